/**
 * Engine-independent functions and types for other packages of this repository, which import this module as `furrow/internal`. Users cannot
 * import it, because `package.json` has no `exports` entry for it. `scripts/lib/sources.mjs` and `tsconfig.base.json` resolve the name.
 */

export { AUTO_SIDES, LINE_REGIONS, sidesOf } from '../src/author/auto/anatomy/region-names.ts'
export { AUTO_STEPS, strokesOf } from '../src/author/auto/auto.ts'
export type { AutoBlood, BloodArea } from '../src/author/auto/blood/draw-blood.ts'
export { BULGES_FROM } from '../src/author/auto/bulges/bulge-driver.ts'
export type { BulgeArea } from '../src/author/auto/bulges/draw-bulges.ts'
export {
  type ChosenSurfaces,
  chooseSurfaces,
  clothNote,
  emptyAside,
  foldsLimb,
  isFoldedAs,
  kindNote,
  kindOfFace,
} from '../src/author/auto/character/choose-surfaces.ts'
export { judgeKind, type MaterialJson, type SurfaceNames } from '../src/author/auto/character/judge-kind.ts'
export { CHARACTER_LIMITS, CharacterBudget } from '../src/author/auto/character/limits.ts'
export { clothOf } from '../src/author/auto/character/named-cloth.ts'
export { SURFACE_KINDS, type SurfaceKind } from '../src/author/auto/character/surface-kinds.ts'
export type { MissingRegion } from '../src/author/auto/fit/fit-driver.ts'
export type { AutoFurrows, FurrowArea } from '../src/author/auto/furrows/draw-net.ts'
export {
  type AreaPlace,
  type AreaView,
  BENT,
  isFolding,
  type JointRotation,
  placeOfArea,
  poseOfDriver,
  viewOfPlace,
} from '../src/author/auto/joints/area-pose.ts'
export { type AreaLineSettings, layAreaLines } from '../src/author/auto/lines/area-lines.ts'
export { regionStrength } from '../src/author/auto/lines/region-strengths.ts'
export { halfSide, heightLevels } from '../src/author/auto/raster/half-side.ts'
export { findBody, findWholeBody } from '../src/author/auto/skeleton/body.ts'
export { boneNameOf } from '../src/author/auto/skeleton/bone-names.ts'
export { type LimbJoints, limbsOf } from '../src/author/auto/skeleton/limbs-of.ts'
export { type StrainMap, strainMaps } from '../src/author/auto/strain-map.ts'
export { MAX_SKIN_TRIANGLES } from '../src/author/auto/surface/check-skin.ts'
export {
  chooseSkin,
  FACE_MOVERS,
  type SkinCandidate,
  type SkinChoice,
} from '../src/author/auto/surface/choose-skin.ts'
export { middleOf } from '../src/author/auto/surface/detect-face.ts'
export { joinParts, type PartInfluences, type SkinPart } from '../src/author/auto/surface/join-parts.ts'
export type { LandmarkPosition as Place, Landmarks } from '../src/author/auto/surface/landmarks.ts'
export { skinSurface } from '../src/author/auto/surface/skin-surface.ts'
export { faceShapeFinder } from '../src/author/auto/surface/stand-ins.ts'
export { moveToFirstTile } from '../src/author/auto/surface/uv-tiles.ts'
export { surfaceOptions } from '../src/author/auto/surface-options.ts'
export { type AutoDriver, autoDrivers } from '../src/author/auto/wrinkle-set.ts'
export { meshDiagonal } from '../src/author/bake/bake.ts'
export { sharedNormals } from '../src/author/bake/mesh.ts'
export type { AnyHit } from '../src/author/bake/occlusion.ts'
export { fileNamesOf, isFileName } from '../src/author/file-names.ts'
export { addFurrows } from '../src/author/furrows/furrows.ts'
export { FINE_FURROW_DEFAULTS, type FurrowRegion, type Furrows } from '../src/author/furrows/read-furrows.ts'
export { type Metric, surfaceMetric } from '../src/author/metric.ts'
export type { Green } from '../src/author/normals/bump-to-normal.ts'
export type { Edges } from '../src/author/normals/slope.ts'
export { correctSkin, parseCorrections, type ShapeCorrection } from '../src/author/shapes/corrections.ts'
export { isSided, SHAPE_NAMES } from '../src/author/shapes/families.ts'
export { type RecognisedShape, recogniseShapes } from '../src/author/shapes/recognise.ts'
export { canvasArrays, canvasFromArrays, mapSkin, type SkinCanvasArrays } from '../src/author/skin/canvas.ts'
export type { SkinTexels, TexelVisitor } from '../src/author/skin/skin-texels.ts'
export { crossOf, type SkinSurface } from '../src/author/skin/surface.ts'
export { type UvGrid, UvLocator } from '../src/author/skin/uv-locator.ts'
export { barycentricsAt, positionAt, walk } from '../src/author/skin/walk.ts'
export type { GroupShape, PolygonShape } from '../src/author/strokes/area-definitions.ts'
export { mergeBounds } from '../src/author/strokes/changed-texels.ts'
export type { LocatedSkin } from '../src/author/strokes/curve.ts'
export {
  type AreaShape,
  type CurveKind,
  SCALE_RANGE,
  STROKE_DEFAULTS,
} from '../src/author/strokes/document.ts'
export {
  nearestOnStroke,
  type StrokeCurve,
  type StrokePoint,
  strokeCurves,
} from '../src/author/strokes/edit/curve-in-space.ts'
export { detachStroke } from '../src/author/strokes/edit/detach.ts'
export { type Fork, type ForkedStrokes, findForks, pointAt } from '../src/author/strokes/edit/forks.ts'
export {
  grabPoint,
  grabStroke,
  grabWeights,
  heldEnds,
  stepTo,
  withPoint,
} from '../src/author/strokes/edit/grab.ts'
export { type MirrorPlane, mirrorStroke } from '../src/author/strokes/edit/mirror.ts'
export {
  type ChangedStrokes,
  knotAt,
  moveFork,
  pullBranches,
  withForkPoints,
} from '../src/author/strokes/edit/move-forks.ts'
export { moveOver, placeAt } from '../src/author/strokes/edit/over-skin.ts'
export { splineOf } from '../src/author/strokes/edit/spline-of.ts'
export { type StrokeLine, StrokeLines } from '../src/author/strokes/edit/stroke-lines.ts'
export { traceStroke, uvOf } from '../src/author/strokes/edit/traced-stroke.ts'
export { addSection, HeightSum } from '../src/author/strokes/height-sum.ts'
export { BANK_WIDTHS, isBulge, sectionOf } from '../src/author/strokes/lay-out.ts'
export { hasOnset } from '../src/author/strokes/onset.ts'
export { groupShape, type PaintedArea, paintArea, paintedNames } from '../src/author/strokes/paint-areas.ts'
export {
  HEIGHT_STEPS_PER_MM,
  MAX_SCULPTED,
  resampleHeights,
  sculptedHeight,
} from '../src/author/strokes/sculpted-sum.ts'
export { drawUvLayout, type UvLayoutOptions } from '../src/author/uv-layout.ts'
export { BLOOD_AMPLITUDE, changedBlood, valleyBlood } from '../src/author/valley-blood.ts'
export { buffersOf } from '../src/auto/buffers.ts'
export { skinOf } from '../src/auto/character.ts'
export { recogniseShapesInWorker } from '../src/auto/recognise-in-worker.ts'
export { keyRotations, rotationChannels, skinJoints } from '../src/auto/skeleton-json.ts'
export { type ActivationPointer, parseActivationPointer } from '../src/core/activation-pointer.ts'
export { BLOOD_ABSORPTION, BLOOD_AT_REST, MAX_BLOOD_AMPLITUDE } from '../src/core/blood.ts'
export { type Bounds, boundsOf, grown } from '../src/core/bounds.ts'
export { CHANNEL, channelOf } from '../src/core/channels.ts'
export { resampleGray, texelAt } from '../src/core/image.ts'
export { JsonReader } from '../src/core/json.ts'
export {
  DEFAULT_AREA_SIZE,
  MAX_AREAS,
  MAX_IMAGE_BYTES,
  MAX_IMAGE_SIDE,
  MAX_LAYERS,
  MAX_NAME_LENGTH,
  MAX_NUMBER,
} from '../src/core/limits.ts'
export { checkDeclared, WRINKLE_MAPS } from '../src/core/maps/declared.ts'
export { DecodedBytes } from '../src/core/maps/decoded-bytes.ts'
export { imageDamage } from '../src/core/maps/image-file.ts'
export { type ImageFileType, imageTypeOf } from '../src/core/maps/image-type.ts'
export {
  type FailKtx2,
  type Ktx2Header,
  type Ktx2Image,
  readKtx2Header,
  readKtx2Image,
} from '../src/core/maps/ktx2-header.ts'
export {
  drawnTextures,
  type MapProblem,
  mapProblems,
  type TextureShape,
  texturesOfFace,
} from '../src/core/maps/rules.ts'
export type {
  MapsAndAreas,
  TextureReference,
  WrinkleMapsArea,
  WrinkleMapsLayer,
} from '../src/core/maps/wrinkle-maps.ts'
export { isName } from '../src/core/name.ts'
export { didYouMean, nearestName } from '../src/core/nearest-name.ts'
export { packAreas, packColours, packGrays } from '../src/core/pack.ts'
export * as reference from '../src/core/reference.ts'
export { interpolateTexels } from '../src/core/reference.ts'
export { repeat } from '../src/core/repeat.ts'
export { checkWrinkleSet } from '../src/core/wrinkle-set.ts'
export { inputName } from '../src/drivers/activation.ts'
export { AGES, type AgeDriver } from '../src/drivers/age/definition.ts'
export { JointMeasurement } from '../src/drivers/bone/measure.ts'
export type { Contribution } from '../src/drivers/contribution.ts'
export { curveAt } from '../src/drivers/curve.ts'
export { describeDriver, describeLink } from '../src/drivers/describe.ts'
export {
  explain,
  needsMesh,
  type Situation,
} from '../src/drivers/explain.ts'
export { expressionsOf } from '../src/drivers/expression/expression.ts'
export { faceExpressions } from '../src/drivers/expression/face-expressions.ts'
export { canonicalTargetName, targetFinder } from '../src/drivers/morph/target-names.ts'
export { VrmWeights } from '../src/drivers/morph/vrm.ts'
export { soleExpressions, vrmExpressions } from '../src/drivers/morph/vrm-binds.ts'
export { parseWrinkleMaps, type WrinkleMaps } from '../src/drivers/parse.ts'
export {
  type DriverPlan,
  type PlannedActivation,
  type PlannedFilter,
  planDrivers,
} from '../src/drivers/plan.ts'
export {
  type BoundInput,
  DriverProgram,
  type DriverState,
  type InputSource,
  type InputSources,
} from '../src/drivers/program.ts'
export { DRIVER_TYPES, isKnownDriver } from '../src/drivers/registry.ts'
export { measuredSource, targetSource, valueSource } from '../src/drivers/sources.ts'
export { TensionMeasurement, type TensionSample } from '../src/drivers/tension/measure.ts'
export { type SampledMesh, sampleTriangles } from '../src/drivers/tension/samples.ts'
export { DeformedNormals, morphNormalDeltas, type RestMesh } from '../src/math/deformed-normals.ts'
export { power } from '../src/math/elementary.ts'
export { clamp, interpolateValues, lerp, rounded, smoothstep } from '../src/math/scalar.ts'
export { splineKnots } from '../src/math/spline.ts'
export { principalStretches, restInverse } from '../src/math/stretch.ts'
export { triangleNormal } from '../src/math/triangle.ts'
export { dot, length3 } from '../src/math/vector.ts'
export { weldVertices } from '../src/math/weld.ts'
export { Activations } from '../src/runtime/activations.ts'
export { ExpressionMix } from '../src/runtime/expression-mix.ts'
export { inflateImage } from '../src/runtime/file/decode-image.ts'
export { drivenFaces } from '../src/runtime/file/driven-faces.ts'
export { hoistTargetNames } from '../src/runtime/file/hoist-target-names.ts'
export { readImage } from '../src/runtime/file/read-image.ts'
export type { FileWrinkles } from '../src/runtime/file/read-wrinkles.ts'
export { describeDriverErrors } from '../src/runtime/file/warnings.ts'

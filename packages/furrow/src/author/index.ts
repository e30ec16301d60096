/**
 * Makes the maps of wrinkles, from strokes, heights, detailed surfaces or blendshapes. Pure functions on typed arrays.
 *
 * @module furrow/author
 */

export type { Bounds } from '../core/bounds.ts'
export { combineNormals } from '../core/normals/combine-normals.ts'
export type { GrayImage, RgbaImage } from '../core/types.ts'
export { AUTO_REGIONS, type AutoRegion } from './auto/anatomy/region-names.ts'
export {
  AUTO_STEPS,
  type AutoArea,
  type AutoProgress,
  type AutoWrinkles,
  autoWrinkles,
  strokesOf,
} from './auto/auto.ts'
export type { AutoBlood, BloodArea } from './auto/blood/draw-blood.ts'
export type { MissingRegion } from './auto/fit/fit-driver.ts'
export type { AutoFurrows, FurrowArea } from './auto/furrows/draw-net.ts'
export { AUTO_DEFAULTS, type AutoOptions } from './auto/options.ts'
export type { AutoLayer } from './auto/raster/draw-maps.ts'
export { halfSide, heightLevels } from './auto/raster/half-side.ts'
export { type StrainMap, strainMaps } from './auto/strain-map.ts'
export { MOST_TRIANGLES } from './auto/surface/check-skin.ts'
export { chooseSkin, type SkinCandidate, type SkinChoice } from './auto/surface/choose-skin.ts'
export { middleOf } from './auto/surface/detect-face.ts'
export { joinParts, type SkinPart } from './auto/surface/join-parts.ts'
export type { LandmarkPosition as Place, Landmarks } from './auto/surface/landmarks.ts'
export { skinSurface } from './auto/surface/skin-surface.ts'
export { faceShapeFinder } from './auto/surface/stand-ins.ts'
export { moveToFirstTile } from './auto/surface/uv-tiles.ts'
export { type AutoDriver, autoDrivers, autoWrinkleSet } from './auto/wrinkle-set.ts'
export {
  BAKE_DEFAULTS,
  type BakedMaps,
  type BakeOptions,
  type BakeSource,
  bakeMaps,
  meshDiagonal,
} from './bake/bake.ts'
export { type BakeMesh, sharedNormals } from './bake/mesh.ts'
export type { AnyHit } from './bake/occlusion.ts'
export { fileNamesOf, isFileName } from './file-names.ts'
export { addFurrows } from './furrows/furrows.ts'
export { FURROW_DEFAULTS, type FurrowRegion, type Furrows } from './furrows/read-furrows.ts'
export { type Metric, type MetricMesh, surfaceMetric } from './metric.ts'
export { heightToNormal, type TangentFrame } from './relief/height-to-normal.ts'
export {
  type Green,
  type NormalMap,
  RELIEF_DEFAULTS,
  type Relief,
  type ReliefOptions,
  reliefToNormal,
} from './relief/relief-to-normal.ts'
export type { Edges } from './relief/slope.ts'
export { mapSkin, type SkinCanvas, skinCanvas } from './skin/canvas.ts'
export type { SkinTexels, TexelVisitor } from './skin/skin-texels.ts'
export { crossOf, type Skin, type SkinSurface, type SkinTarget } from './skin/surface.ts'
export type { UvGrid, UvLocator } from './skin/uv-locator.ts'
export { barycentricsAt, walk } from './skin/walk.ts'
export type { GroupShape, PolygonShape } from './strokes/area-definitions.ts'
export type { LocatedSkin } from './strokes/curve.ts'
export {
  type AreaDefinition,
  type AreaShape,
  type CurveKind,
  parseStrokes,
  STROKE_DEFAULTS,
  type Stroke,
  type StrokesDocument,
  type Uv,
} from './strokes/document.ts'
export {
  nearestOnStroke,
  type StrokeCurve,
  type StrokePoint,
  strokeCurves,
} from './strokes/edit/curve-in-space.ts'
export { type MirrorPlane, mirrorStroke } from './strokes/edit/mirror.ts'
export { insertPoint, removePoint, smoothStroke } from './strokes/edit/points.ts'
export { splineOf } from './strokes/edit/spline-of.ts'
export { splitStroke } from './strokes/edit/split.ts'
export { type HeightMap, strokesToHeight } from './strokes/height.ts'
export { GROUP_SHAPE, type PaintedArea, paintArea, paintAreas, paintedNames } from './strokes/paint-areas.ts'
export { StrokeLayer, type StrokeLayerOptions } from './strokes/stroke-layer.ts'
export { targetArea } from './target-area.ts'
export { drawUvLayout, type UvLayoutOptions } from './uv-layout.ts'
export { BLOOD_AMPLITUDE, changedBlood, valleyBlood } from './valley-blood.ts'

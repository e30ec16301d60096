/**
 * Creates wrinkle maps from strokes, heights, detailed surfaces or blendshapes. The functions work on typed arrays and need no engine.
 *
 * @module furrow/author
 */

export { combineNormals } from '../core/normals/combine-normals.ts'
export type { GrayImage, RgbaImage } from '../core/types.ts'
export {
  AUTO_REGIONS,
  type AutoRegion,
  type AutoSide,
  DENSE_REGIONS,
  type DenseRegion,
} from './auto/anatomy/region-names.ts'
export {
  type AutoArea,
  type AutoProgress,
  type AutoWrinkles,
  autoWrinkles,
  type JointArea,
} from './auto/auto.ts'
export { CLOTH_KINDS, type ClothKind } from './auto/cloth/cloth-kinds.ts'
export { AUTO_DEFAULTS, type AutoOptions } from './auto/options.ts'
export { type AutoPreset, parseAutoPreset } from './auto/preset.ts'
export type { AutoLayer } from './auto/raster/draw-maps.ts'
export { autoWrinkleSet } from './auto/wrinkle-set.ts'
export { BAKE_DEFAULTS, type BakedMaps, type BakeOptions, type BakeSource, bakeMaps } from './bake/bake.ts'
export type { BakeMesh } from './bake/mesh.ts'
export type { MetricMesh } from './metric.ts'
export {
  BUMP_DEFAULTS,
  type BumpMap,
  type BumpOptions,
  bumpToNormal,
  type NormalMap,
} from './normals/bump-to-normal.ts'
export { heightToNormal, type TangentFrame } from './normals/height-to-normal.ts'
export { type SkinCanvas, skinCanvas } from './skin/canvas.ts'
export type { SkinJoint, SkinSkeleton } from './skin/skeleton.ts'
export type { Skin, SkinTarget } from './skin/surface.ts'
export {
  type AreaDefinition,
  parseStrokes,
  type Stroke,
  type StrokesDocument,
  type Uv,
} from './strokes/document.ts'
export { insertPoint, removePoint } from './strokes/edit/points.ts'
export { smoothStroke } from './strokes/edit/smooth.ts'
export { splitStroke } from './strokes/edit/split.ts'
export { type HeightMap, strokesToHeight } from './strokes/height.ts'
export { strokesToOnset } from './strokes/onset.ts'
export { paintAreas } from './strokes/paint-areas.ts'
export { StrokeLayer, type StrokeLayerOptions } from './strokes/stroke-layer.ts'
export { targetArea } from './target-area.ts'

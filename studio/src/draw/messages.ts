import type { RgbaImage } from 'furrow'
import type { MetricMesh, Stroke, TangentFrame } from 'furrow/author'
import type { Bounds } from 'furrow/internal'
import type { ListChanges } from './changes.ts'

/** Skin for drawing strokes, and the maps' properties. */
export interface DrawingSurface {
  readonly mesh: MetricMesh
  /** Side of the maps, texels. */
  readonly size: number
  /** Millimetres per unit of the mesh's positions. */
  readonly scale: number
  readonly frame: TangentFrame
}

/** Changed texels of a layer's maps. */
export interface MapPatch {
  bounds: Bounds
  /** RGBA, row by row. */
  normal: Uint8Array
  /** One byte per texel, 255 = not occluded. */
  occlusion: Uint8Array
}

/** API of the drawing worker. */
export interface DrawingService {
  /** Starts with another skin or map size. Removes all layers. */
  begin(surface: DrawingSurface): void
  /** Adds or resets a layer, over an optional normal map of the same size. */
  addLayer(name: string, base: RgbaImage | null): void
  /** Draws changes of a layer's strokes. */
  draw(name: string, changes: ListChanges<Stroke>): MapPatch[]
  /** Prepares the edit of a stroke, given by its index in the layer, until the next call. Null cancels. */
  prepare(stroke: { layer: string; index: number } | null): Promise<void>
  /** Copies the heights of a layer's strokes; see `HeightMap`. */
  heights(name: string): Float32Array
}

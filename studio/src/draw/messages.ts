import type { RgbaImage } from 'furrow'
import type { MetricMesh, Stroke, TangentFrame } from 'furrow/author'
import type { Bounds } from 'furrow/internal'
import type { ListChanges, SculptedChanges } from './changes.ts'

/** Skin on which strokes are drawn, and size of the maps. */
export interface DrawingSurface {
  readonly mesh: MetricMesh
  /** Width and height of the maps, texels. */
  readonly size: number
  /** Millimetres per unit of the mesh's positions. */
  readonly scale: number
  readonly frame: TangentFrame
}

/** Settings of a layer that is drawn from strokes. */
export interface LayerSettings {
  /** Normal map on which strokes are drawn, or null for flat normals. Its width and height are `DrawingSurface.size`. */
  readonly base: RgbaImage | null
  /** Whether to draw an onset map. */
  readonly hasOnset: boolean
}

/** Changed texels of a layer's maps. */
export interface MapPatch {
  bounds: Bounds
  /** Texels of the normal map, RGBA, row by row. */
  normal: Uint8Array
  /** Texels of the occlusion map, one byte each; 255 is not occluded. */
  occlusion: Uint8Array
  /** Texels of the onset map, one byte each. Absent for layers without one. */
  onset?: Uint8Array
}

/** API of the worker that draws wrinkle strokes into the maps of layers. */
export interface DrawingService {
  /** Sets the skin and the size of the maps. Removes all layers. */
  begin(surface: DrawingSurface): void
  /** Adds a layer without strokes. Replaces a layer with the same name. */
  addLayer(name: string, settings: LayerSettings): void
  /**
   * Draws the changed strokes and sculpted heights of a layer, and returns the changed texels.
   *
   * @param sculpted null: the sculpted heights have not changed.
   */
  draw(name: string, changes: ListChanges<Stroke>, sculpted: SculptedChanges | null): MapPatch[]
  /** Prepares the edit of a stroke, given by its index in the layer. A later `prepare` or `begin` cancels unfinished work. Null only cancels. */
  prepare(stroke: { layer: string; index: number } | null): Promise<void>
  /** Returns a copy of the heights of a layer's strokes and sculpted heights; see `HeightMap`. */
  heights(name: string): Float32Array
}

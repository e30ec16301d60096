import type { RgbaImage } from 'furrow'
import type { MetricMesh, Stroke, TangentFrame } from 'furrow/author'
import type { Bounds } from 'furrow/internal'
import type { ListChanges } from './changes.ts'

/** The skin that strokes are drawn on, and how. */
export interface DrawingSurface {
  readonly mesh: MetricMesh
  /** Side of the maps in texels. */
  readonly size: number
  /** Millimetres per unit of the mesh's positions. */
  readonly scale: number
  readonly frame: TangentFrame
}

/** Texels of the maps of a layer that changed. */
export interface MapPatch {
  bounds: Bounds
  /** RGBA, row by row. */
  normal: Uint8Array
  /** 255 = open to the light. */
  occlusion: Uint8Array
}

/** What the drawing worker does. */
export interface DrawingService {
  /** Begins with another skin, or maps of another size: all layers are without strokes. */
  begin(surface: DrawingSurface): void
  /** Begins a layer, or begins it again, over a normal map of the same size where there is one. */
  addLayer(name: string, base: RgbaImage | null): void
  /** Draws what changed of a layer's strokes. */
  draw(name: string, changes: ListChanges<Stroke>): MapPatch[]
  /** Prepares the next edit of a stroke of a layer, given by its index, until another one is asked for; null for none. */
  prepare(stroke: { layer: string; index: number } | null): Promise<void>
  /** A copy of the heights of a layer's strokes; see `HeightMap`. */
  heights(name: string): Float32Array
}

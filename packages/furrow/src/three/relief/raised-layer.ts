import type { ArraySlice, GrayImage, Layer } from '../../core/types.ts'

/** A layer whose height map is decoded on first use, because most faces are too small on screen for height maps to matter. */
export interface RaisedLayer extends Layer<ArraySlice> {
  /** Decodes the height map; cached. Rejects if the map cannot be read. */
  readHeight?: () => Promise<GrayImage | ArraySlice>
}

/** Whether a layer has a height map that displaces the surface. */
export function hasHeights({ height, readHeight, heightAmplitude = 0 }: RaisedLayer): boolean {
  return Boolean(height ?? readHeight) && heightAmplitude > 0
}

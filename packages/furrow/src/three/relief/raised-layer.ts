import type { ArraySlice, GrayImage, Layer } from '../../core/types.ts'

/** A layer whose heights are decoded on first use, because most faces are too small on screen for relief. */
export interface RaisedLayer extends Layer<ArraySlice> {
  /** Decodes the heights; cached. Rejects if they cannot be read. */
  readHeight?: () => Promise<GrayImage | ArraySlice>
}

/** Whether a layer has heights that displace the surface. */
export function hasHeights({ height, readHeight, heightAmplitude = 0 }: RaisedLayer): boolean {
  return Boolean(height ?? readHeight) && heightAmplitude > 0
}

import type { ArraySlice, GrayImage, Layer } from '../../core/types.ts'

/** A layer whose heights a file has, and decodes when relief is first wanted: most faces on most pages are too small for it. */
export interface RaisedLayer extends Layer<ArraySlice> {
  /** Decodes them, once; rejects where they cannot be read. */
  readHeight?: () => Promise<GrayImage | ArraySlice>
}

/** Whether a layer can move the surface. */
export function canRise({ height, readHeight, heightAmplitude = 0 }: RaisedLayer): boolean {
  return Boolean(height ?? readHeight) && heightAmplitude > 0
}

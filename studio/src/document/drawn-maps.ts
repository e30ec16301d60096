import type { GrayImage, RgbaImage } from 'furrow'

/** Maps of a layer that are drawn from strokes. */
export interface DrawnMaps {
  readonly normal: RgbaImage
  readonly occlusion: GrayImage
}

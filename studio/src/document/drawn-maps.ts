import type { GrayImage, RgbaImage } from 'furrow'

/** Layer maps drawn from strokes. */
export interface DrawnMaps {
  readonly normal: RgbaImage
  readonly occlusion: GrayImage
}

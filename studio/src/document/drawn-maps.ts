import type { GrayImage, RgbaImage } from 'furrow'

/** Layer maps drawn from strokes. */
export interface DrawnMaps {
  readonly normal: RgbaImage
  readonly occlusion: GrayImage
  /** Absent unless `isOnsetDrawn` of the layer is set. */
  readonly onset?: GrayImage
}

import type { Bounds } from '../core/bounds.ts'
import type { Combine } from '../core/types.ts'

/** Location of one area's weights in a texture array. */
export interface AreaSlot {
  /** Index of the layer. */
  layer: number
  combine: Combine
  slice: number
  /** Channel of the slice, 0 = R to 3 = A. */
  channel: number
  /** Bounding rectangle of all texels with a weight above 0. */
  bounds: Bounds
}

/** Locations of all areas of a wrinkle set in one texture array. Each slice has `width` x `height` texels. */
export interface AreaSlots {
  readonly width: number
  readonly height: number
  /** One slot per area, in the order of the activations. */
  readonly slots: readonly AreaSlot[]
  /** Incremented on every change of weights. */
  version: number
}

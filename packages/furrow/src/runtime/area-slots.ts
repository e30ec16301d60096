import type { Bounds } from '../core/bounds.ts'
import type { Combine } from '../core/types.ts'

/** Location of an area's weights in a texture array. Slots and activations are in the same order. */
export interface AreaSlot {
  /** Index of the layer. */
  layer: number
  combine: Combine
  slice: number
  /** Channel of the slice, 0 = R to 3 = A. */
  channel: number
  /** Bounds of all texels with a weight above 0. */
  bounds: Bounds
}

/** Areas of a set in one array of `width` x `height` texels per slice. */
export interface AreaSlots {
  readonly width: number
  readonly height: number
  readonly slots: readonly AreaSlot[]
  /** Incremented on every change of weights. */
  version: number
}

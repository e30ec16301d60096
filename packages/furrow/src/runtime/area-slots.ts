import type { Bounds } from '../core/bounds.ts'
import type { Combine } from '../core/types.ts'

/** Where one area is in an array of areas. Slots and activations are in the same order. */
export interface AreaSlot {
  /** Index of its layer. */
  layer: number
  combine: Combine
  slice: number
  /** Channel of the slice, 0 = R to 3 = A. */
  channel: number
  /** Contains all texels where its weight is above 0. */
  bounds: Bounds
}

/** The areas of a set as one array of `width` x `height` texels per slice. */
export interface AreaSlots {
  readonly width: number
  readonly height: number
  readonly slots: readonly AreaSlot[]
  /** Incremented when weights change. */
  version: number
}

import type { Bounds } from '../core/bounds.ts'
import type { Combine } from '../core/types.ts'

/** Where one area is in an array of areas; its activation has the same index. */
export interface AreaSlot {
  /** Index of its layer. */
  layer: number
  combine: Combine
  /** Slice of the array, channel of that slice. */
  slice: number
  channel: number
  /** The texels where its weight is above 0. */
  bounds: Bounds
}

/** The areas of a set as one array of `width` x `height` texels per slice. */
export interface AreaSlots {
  readonly width: number
  readonly height: number
  readonly slots: readonly AreaSlot[]
}

import type { Vector4 } from 'three'
import { type Bounds, widen } from '../core/bounds.ts'
import type { AreaArray } from './atlas/area-array.ts'

/** Beyond any texture coordinate. */
const FAR = 1e9

/** Filled anew by each call, so that a frame allocates none. */
const span: Bounds = { x0: 0, y0: 0, x1: 0, y1: 0 }

/**
 * The rectangle of texture coordinates outside of which nothing shows: that of all areas that are not at rest. Skin outside of
 * it need not even sample the influence map. Empty where all are at rest.
 *
 * @param values activations in the order of the areas.
 * @param reach is set to u0, v0, u1, v1.
 */
export function findReach({ slots, width, height }: AreaArray, values: Float32Array, reach: Vector4): void {
  span.x0 = width
  span.y0 = height
  span.x1 = 0
  span.y1 = 0
  for (let i = 0; i < slots.length; i++) if (values[i] !== 0) widen(span, slots[i].bounds)
  const { x0, y0, x1, y1 } = span
  // Filtered, a texel reaches to the middle of the next one, and the outermost ones of the map reach everywhere.
  // One by one: numbers given to a function may be allocated.
  reach.x = x0 < 1 ? -FAR : (x0 - 0.5) / width
  reach.y = y0 < 1 ? -FAR : (y0 - 0.5) / height
  reach.z = x1 > width - 1 ? FAR : (x1 + 0.5) / width
  reach.w = y1 > height - 1 ? FAR : (y1 + 0.5) / height
}

/** For several faces at once: everything is in reach. */
export function reachAll(reach: Vector4): void {
  reach.set(-FAR, -FAR, FAR, FAR)
}

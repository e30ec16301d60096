import { type Bounds, widen } from '../core/bounds.ts'
import type { AreaSlots } from './area-slots.ts'

/** A rectangle of texture coordinates: u0, v0, u1, v1 as x, y, z, w, compatible with the vector classes of engines. */
export interface Reach {
  x: number
  y: number
  z: number
  w: number
}

/** Larger than any texture coordinate. */
const FAR = 1e9

/** Scratch, so that frames allocate nothing. */
const span: Bounds = { x0: 0, y0: 0, x1: 0, y1: 0 }

/**
 * Computes the bounds of all active areas in texture coordinates; empty if no area is active. Skin outside can skip sampling the
 * influence map.
 *
 * @param values activations, in the order of the areas.
 * @param reach receives the rectangle.
 */
export function findReach({ slots, width, height }: AreaSlots, values: Float32Array, reach: Reach): void {
  span.x0 = width
  span.y0 = height
  span.x1 = 0
  span.y1 = 0
  for (let i = 0; i < slots.length; i++) if (values[i] !== 0) widen(span, slots[i].bounds)
  const { x0, y0, x1, y1 } = span
  // Bilinear filtering spreads a texel to the centres of its neighbours; clamping extends border texels infinitely.
  // Statements, because V8 allocates numbers in conditional expressions and in a shared function.
  if (x0 < 1) reach.x = -FAR
  else reach.x = (x0 - 0.5) / width
  if (y0 < 1) reach.y = -FAR
  else reach.y = (y0 - 0.5) / height
  if (x1 > width - 1) reach.z = FAR
  else reach.z = (x1 + 0.5) / width
  if (y1 > height - 1) reach.w = FAR
  else reach.w = (y1 + 0.5) / height
}

/** Sets a rectangle that contains everything, for several faces together. */
export function reachAll(reach: Reach): void {
  reach.x = -FAR
  reach.y = -FAR
  reach.z = FAR
  reach.w = FAR
}

/** Sets an empty rectangle. */
export function reachNothing(reach: Reach): void {
  reach.x = 1
  reach.y = 1
  reach.z = 0
  reach.w = 0
}

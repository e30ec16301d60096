import { type Bounds, widen } from '../core/bounds.ts'
import type { AreaSlots } from './area-slots.ts'

/**
 * Rectangle in texture coordinates that contains all texels with a weight above 0 in an area with an activation above 0. Its edges u0, v0,
 * u1 and v1 are stored as x, y, z and w, so that the vector classes of engines are compatible.
 */
export interface Reach {
  x: number
  y: number
  z: number
  w: number
}

/** A number larger than any texture coordinate. */
const FAR = 1e9

/** Scratch rectangle, reused so that frames allocate nothing. */
const span: Bounds = { x0: 0, y0: 0, x1: 0, y1: 0 }

/**
 * Computes the rectangle outside which no wrinkles are visible. It is empty if all activations are 0. Shaders need to sample influences only
 * inside this rectangle.
 *
 * @param values activations, in the order of the slots.
 * @param reach receives the rectangle.
 */
export function findReach({ slots, width, height }: AreaSlots, values: Float32Array, reach: Reach): void {
  span.x0 = width
  span.y0 = height
  span.x1 = 0
  span.y1 = 0
  for (let i = 0; i < slots.length; i++) if (values[i] !== 0) widen(span, slots[i].bounds)
  const { x0, y0, x1, y1 } = span
  // Bilinear filtering spreads a texel to the centres of its neighbours. Clamping extends texels at the border of the map infinitely.
  // V8 would allocate numbers for conditional expressions or function calls here, so the code repeats if statements.
  if (x0 < 1) reach.x = -FAR
  else reach.x = (x0 - 0.5) / width
  if (y0 < 1) reach.y = -FAR
  else reach.y = (y0 - 0.5) / height
  if (x1 > width - 1) reach.z = FAR
  else reach.z = (x1 + 0.5) / width
  if (y1 > height - 1) reach.w = FAR
  else reach.w = (y1 + 0.5) / height
}

/** Extends a rectangle to contain all texture coordinates. */
export function reachAll(reach: Reach): void {
  reach.x = -FAR
  reach.y = -FAR
  reach.z = FAR
  reach.w = FAR
}

export function reachNothing(reach: Reach): void {
  reach.x = 1
  reach.y = 1
  reach.z = 0
  reach.w = 0
}

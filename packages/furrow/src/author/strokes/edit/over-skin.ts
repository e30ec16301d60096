import { length } from '../../../math/vector.ts'
import { barycentricsAt, positionAt, walk } from '../../skin/walk.ts'
import type { LocatedSkin } from '../curve.ts'
import type { Uv } from '../document.ts'
import { clamped } from './traced-stroke.ts'

/** Maximum step length in millimetres, because `walk` crosses only a few triangles per call. */
const STEP = 0.5

/** Point of the skin: its triangle, and its position in millimetres. */
export interface SkinSpot {
  triangle: number
  position: Float64Array
}

/** Returns the point of the skin at UV coordinates, or null if there is no skin. */
export function placeAt([u, v]: Uv, { surface, locator }: LocatedSkin): SkinSpot | null {
  const weights = new Float64Array(3)
  const triangle = locator.find(u, v, weights)
  if (triangle < 0) return null
  const position = new Float64Array(3)
  positionAt(position, surface, triangle, weights)
  return { triangle, position }
}

/**
 * Moves a point over the skin. The point stops at the skin's border.
 *
 * @param step direction and distance, millimetres. The direction is projected onto each triangle.
 * @returns UV coordinates of the moved point.
 */
export function moveOver({ triangle, position }: SkinSpot, step: Float64Array, skin: LocatedSkin): Uv {
  const steps = Math.ceil(length(step) / STEP)
  let [here, at] = [triangle, position]
  for (let n = 0; n < steps; n++) {
    const next = at.slice()
    const reached = walk(skin.surface, here, next, step, length(step) / steps)
    if (reached < 0) break
    ;[here, at] = [reached, next]
  }
  const weights = new Float64Array(3)
  barycentricsAt(weights, skin.surface, here, at)
  return clamped(skin.locator.uvAt(here, weights))
}

import { cos, sin } from '../../math/elementary.ts'
import { hash32 } from '../../math/hash.ts'

/** Returns whether a ray from (x, y, z) in the unit direction (dx, dy, dz) hits the front or back of a surface within `far` metres. */
export type AnyHit = (
  x: number,
  y: number,
  z: number,
  dx: number,
  dy: number,
  dz: number,
  far: number,
) => boolean

/**
 * Returns the ambient visibility of a point, 0..1: the cosine-weighted fraction of unoccluded directions in the hemisphere around its normal.
 * Directions are a Hammersley set mapped by Malley's method (Pharr, Jakob and Humphreys, Physically Based Rendering, 13.6.3). `seed` shifts
 * the set randomly; the same seed gives the same result.
 *
 * @param point x, y and z.
 * @param n unit normal.
 * @param rays number of rays.
 * @param far length of the rays in metres.
 */
export function ambientVisibility(
  anyHit: AnyHit,
  point: ArrayLike<number>,
  n: ArrayLike<number>,
  rays: number,
  far: number,
  seed: number,
): number {
  const [nx, ny, nz] = [n[0], n[1], n[2]]
  // Two vectors perpendicular to n (Duff et al. 2017, Building an Orthonormal Basis, Revisited).
  const sign = nz < 0 ? -1 : 1
  const a = -1 / (sign + nz)
  const b = nx * ny * a
  const [sx, sy, sz] = [1 + sign * nx * nx * a, sign * b, -sign * nx]
  const [tx, ty, tz] = [b, sign + ny * ny * a, -ny]
  const [shift, turn] = [random(seed), random(seed ^ 0x5bd1e995)]
  let open = 0
  for (let i = 0; i < rays; i++) {
    const u = (i + shift) / rays
    const angle = 2 * Math.PI * (radicalInverse(i) + turn)
    const [p, q, r] = [Math.sqrt(u) * cos(angle), Math.sqrt(u) * sin(angle), Math.sqrt(1 - u)]
    const dx = p * sx + q * tx + r * nx
    const dy = p * sy + q * ty + r * ny
    const dz = p * sz + q * tz + r * nz
    if (!anyHit(point[0], point[1], point[2], dx, dy, dz, far)) open++
  }
  return open / rays
}

/** Returns the fraction, 0..1, whose binary digits are those of `i` in reverse order (van der Corput sequence). */
function radicalInverse(i: number): number {
  let value = 0
  for (let half = 0.5, k = i; k > 0; half /= 2, k >>>= 1) if (k & 1) value += half
  return value
}

/** Returns a random number in 0..1, excluding 1. */
function random(seed: number): number {
  return hash32(seed) / 4294967296
}

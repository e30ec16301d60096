/** Says whether a ray from a point meets anything within `far` metres. */
export type Blocked = (
  x: number,
  y: number,
  z: number,
  dx: number,
  dy: number,
  dz: number,
  far: number,
) => boolean

/**
 * Share of the sky that a point with normal n sees, weighted by the cosine to the normal as diffuse light is: rays spread
 * by Malley's method over a disc (Pharr, Jakob and Humphreys, Physically Based Rendering, 13.6.3), a Hammersley set turned
 * by a random amount that depends on `seed` alone, so that the same seed gives the same share.
 */
export function openness(
  blocked: Blocked,
  at: ArrayLike<number>,
  n: ArrayLike<number>,
  rays: number,
  far: number,
  seed: number,
): number {
  const [nx, ny, nz] = [n[0], n[1], n[2]]
  // Two vectors at right angles to n (Duff et al. 2017, Building an Orthonormal Basis, Revisited).
  const sign = nz < 0 ? -1 : 1
  const a = -1 / (sign + nz)
  const b = nx * ny * a
  const [sx, sy, sz] = [1 + sign * nx * nx * a, sign * b, -sign * nx]
  const [tx, ty, tz] = [b, sign + ny * ny * a, -ny]
  const [turn1, turn2] = [hash(seed), hash(seed ^ 0x5bd1e995)]
  let open = 0
  for (let i = 0; i < rays; i++) {
    const u = (i + turn1) / rays
    const angle = 2 * Math.PI * (radicalInverse(i) + turn2)
    const [p, q, r] = [Math.sqrt(u) * Math.cos(angle), Math.sqrt(u) * Math.sin(angle), Math.sqrt(1 - u)]
    const dx = p * sx + q * tx + r * nx
    const dy = p * sy + q * ty + r * ny
    const dz = p * sz + q * tz + r * nz
    if (!blocked(at[0], at[1], at[2], dx, dy, dz, far)) open++
  }
  return open / rays
}

/** The bits of i mirrored behind the point (van der Corput). */
function radicalInverse(i: number): number {
  let value = 0
  for (let half = 0.5, k = i; k > 0; half /= 2, k >>>= 1) if (k & 1) value += half
  return value
}

/** A number in 0..1 that looks random (the finaliser of MurmurHash3, A. Appleby, public domain). */
function hash(seed: number): number {
  let h = seed | 0
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296
}

/**
 * Computes `uu * u * u + 2 * uv * u * v + vv * v * v`. Pass the first fundamental form of a surface as `uu`, `uv` and `vv`, and a step in texture
 * coordinates as `u` and `v`. The result is the squared length of this step on the surface.
 */
export function quadraticForm(uu: number, uv: number, vv: number, u: number, v: number): number {
  return uu * u * u + 2 * uv * u * v + vv * v * v
}

/**
 * Computes `uu * u * u + 2 * uv * u * v + vv * v * v`. If `uu`, `uv` and `vv` are the first fundamental form of a surface, this is the squared
 * length on the surface of the step (u, v) in texture coordinates.
 */
export function quadraticForm(uu: number, uv: number, vv: number, u: number, v: number): number {
  return uu * u * u + 2 * uv * u * v + vv * v * v
}

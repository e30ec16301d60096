/** Evaluates uu u^2 + 2 uv u v + vv v^2: the squared length of a step (u, v) under the first fundamental form of a surface. */
export function quadraticForm(uu: number, uv: number, vv: number, u: number, v: number): number {
  return uu * u * u + 2 * uv * u * v + vv * v * v
}

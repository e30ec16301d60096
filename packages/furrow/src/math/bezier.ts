/** Evaluates a 2D cubic Bezier curve at `t`, 0..1, in Bernstein form. */
export function bezierAt(
  a: readonly [number, number],
  b: readonly [number, number],
  c: readonly [number, number],
  d: readonly [number, number],
  t: number,
): [number, number] {
  const s = 1 - t
  const at = (k: 0 | 1) => s * s * s * a[k] + 3 * s * s * t * b[k] + 3 * s * t * t * c[k] + t * t * t * d[k]
  return [at(0), at(1)]
}

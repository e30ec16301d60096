export function clamp(x: number, low: number, high: number): number {
  return Math.min(Math.max(x, low), high)
}

/** Returns the smallest power of two that is at least `x`; 1 if `x` is less than 1. */
export function powerOfTwoFrom(x: number): number {
  let power = 1
  while (power < x) power *= 2
  return power
}

/** Interpolates linearly between `a` (at `t = 0`) and `b` (at `t = 1`). */
export function lerp(a: number, b: number, t: number): number {
  return a + t * (b - a)
}

/** Interpolates linearly between at least two values at even distances. `t` is clamped to 0 (the first value) .. 1 (the last value). */
export function interpolateValues(values: ArrayLike<number>, t: number): number {
  const x = clamp(t, 0, 1) * (values.length - 1)
  const from = Math.min(Math.floor(x), values.length - 2)
  return lerp(values[from], values[from + 1], x - from)
}

/** Clamps `x` to 0..1, and returns `3 * x^2 - 2 * x^3`. */
export function smoothstep(x: number): number {
  const t = clamp(x, 0, 1)
  return t * t * (3 - 2 * t)
}

/** Rounds `x` to a multiple of `1 / steps`. */
/** Returns 1 up to `from`, 0 from `to` on, and values of `smoothstep` between. */
export function fadeOut(x: number, [from, to]: readonly [from: number, to: number]): number {
  return 1 - smoothstep((x - from) / (to - from))
}

export function rounded(x: number, steps: number): number {
  return Math.round(steps * x) / steps
}

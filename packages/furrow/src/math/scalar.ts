export function clamp(x: number, low: number, high: number): number {
  return Math.min(Math.max(x, low), high)
}

export function lerp(a: number, b: number, t: number): number {
  return a + t * (b - a)
}

/** 3 x^2 - 2 x^3, with x clamped to 0..1. */
export function smoothstep(x: number): number {
  const t = clamp(x, 0, 1)
  return t * t * (3 - 2 * t)
}

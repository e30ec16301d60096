import { clamp, power, rounded } from 'furrow/internal'

/** A curve with at most as many points as drivers may have. */
const POINTS = 49
/** Points are multiples of 1 / `STEPS`. */
const STEPS = 1e6

/**
 * Samples the curve `shape(min(1, strength x^exponent))` for a driver. Points are closer where the power rises steeply.
 *
 * @param shape maps 0..1 to 0..1.
 */
export function powerCurve(
  strength: number,
  exponent: number,
  shape: (value: number) => number = (value) => value,
): [number, number][] {
  if (strength === 0) {
    return [
      [0, 0],
      [1, 0],
    ]
  }
  const end = 1 / power(strength, 1 / exponent)
  const isLinear = exponent === 1 && [0.25, 0.5, 0.75].every((value) => Math.abs(shape(value) - value) < 1e-9)
  const count = isLinear ? 2 : POINTS
  const points = Array.from({ length: count }, (_, i): [number, number] => {
    const input = end * power(i / (count - 1), Math.max(1, 1 / exponent))
    const value = Math.min(1, strength * power(input, exponent))
    return [rounded(input, STEPS), rounded(clamp(shape(value), 0, 1), STEPS)]
  })
  return points.filter(([input], i) => i === 0 || input > points[i - 1][0])
}

import { exp } from '../../../math/elementary.ts'

/** Limit of the compression. More would need folds that are deeper than wide. */
const LIMIT = 0.35
/** Maximum stretch. Stronger stretch does not make the skin flatter. */
const MAX_STRETCH = 0.15

/** Limits a compression smoothly: `LIMIT * tanh(e / LIMIT)`. Stretch, which is negative, is cut off. */
export function softlyClamped(compression: number): number {
  if (compression <= 0) return Math.max(-MAX_STRETCH, compression)
  const square = exp((-2 * compression) / LIMIT)
  return (LIMIT * (1 - square)) / (1 + square)
}

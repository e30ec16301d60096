import type { WrinkleSet } from 'furrow'
import { influenceAt } from './influence-at.ts'

/** Transform of the texture coordinates of `square`. */
export interface UvTransform {
  scale: number
  offset: readonly number[]
}

/**
 * Returns the largest difference between the influence of a drawn square and the float64 reference.
 *
 * @param set wrinkle set whose areas have `areaSize` x `areaSize` texels.
 * @param activations activations of the areas when the square was drawn.
 * @param shown returns the drawn influence at a pixel index.
 * @param side width of the picture, pixels.
 */
export function influenceDifference(
  set: WrinkleSet,
  areaSize: number,
  activations: readonly number[],
  { scale, offset }: UvTransform,
  shown: (pixel: number) => number,
  side: number,
): number {
  const exactAt = influenceAt(set.areas, activations, areaSize)
  let largest = 0
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      const u = ((x + 0.5) / side) * scale + offset[0]
      const v = (1 - (y + 0.5) / side) * scale + offset[1]
      largest = Math.max(largest, Math.abs(shown(y * side + x) - exactAt(u, v)))
    }
  }
  return largest
}

import type { PlannedRegion } from './plan-net.ts'

/**
 * Computes, at a position, the weight of each region with fine furrows. Inside the regions, the weights add up to 1, so that furrows are
 * continuous where regions overlap.
 *
 * @param out receives one weight per region.
 */
export function netWeights(
  regions: readonly PlannedRegion[],
  x: number,
  y: number,
  z: number,
  out: Float64Array,
): void {
  let total = 0
  for (const [i, { spheres }] of regions.entries()) {
    out[i] = 0
    for (const { position, radius } of spheres) {
      const square = (x - position[0]) ** 2 + (y - position[1]) ** 2 + (z - position[2]) ** 2
      if (square < radius ** 2) out[i] += (1 - square / radius ** 2) ** 2
    }
    total += out[i]
  }
  if (total > 0) for (let i = 0; i < regions.length; i++) out[i] /= total
}

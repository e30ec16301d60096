import type { PlannedRegion } from './plan-net.ts'

/**
 * Computes the weights of a net's regions at a position. They sum to 1 wherever there is a net, so the net is continuous across regions.
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

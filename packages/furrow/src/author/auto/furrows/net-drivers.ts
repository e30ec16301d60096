import type { Curve } from '../../../drivers/curve.ts'
import type { MorphDriver } from '../../../drivers/morph/definition.ts'
import { roundWeight } from '../fit/fit-driver.ts'
import { visibility } from '../raster/visibility.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { compressionTensors, TENSOR_SIZE } from '../surface/tensors.ts'
import { netWeights } from './net-weights.ts'
import { AT_REST, type PlannedRegion } from './plan-net.ts'

/** Furrows have full depth if the skin has lost this fraction of its area. */
const SQUEEZED = 0.12
/** Furrows are smoothest if the skin has gained this fraction of its area. */
const PULLED = 0.2
/** Activation of the smoothest furrows. */
const SMOOTH = 0.1
/** Targets (blendshapes) that change the skin's area by less than this fraction are ignored. */
const NEGLIGIBLE = 0.004
const MAX_TARGETS = 24

/**
 * Creates the drivers of fine furrows. Compressed skin gets rougher, and stretched skin smoother (Nagano et al. 2015, Skin microstructure
 * deformation with displacement map convolution). For each region, the function measures by which fraction each target
 * (blendshape) shrinks the area of the skin. This fraction is nearly linear in the target's weight, so a linear combination of the targets'
 * weights activates the furrows.
 */
export function netDrivers(
  { chart, surface, offsets, names }: DetectedFace,
  regions: readonly PlannedRegion[],
): MorphDriver[] {
  const { points, normals, areas } = surface
  const weights = new Float64Array(areas.length * regions.length)
  const totals = new Float64Array(regions.length)
  for (let point = 0; point < areas.length; point++) {
    const own = weights.subarray(regions.length * point, regions.length * (point + 1))
    const [x, y, z] = points.subarray(3 * point, 3 * point + 3)
    netWeights(regions, x, y, z, own)
    const visible = visibility(chart, x, y, z, normals.subarray(3 * point, 3 * point + 3))
    for (let i = 0; i < regions.length; i++) {
      own[i] *= visible
      totals[i] += areas[point] * own[i]
    }
  }
  const links = regions.map((): { name: string; weight: number }[] => [])
  for (const [target, offset] of offsets.entries()) {
    const lost = new Float64Array(regions.length)
    const tensors = compressionTensors(surface, offset)
    for (let point = 0; point < areas.length; point++) {
      const first = TENSOR_SIZE * point
      const trace = tensors[first] + tensors[first + 3] + tensors[first + 5]
      if (trace === 0) continue
      for (let i = 0; i < regions.length; i++)
        lost[i] += areas[point] * weights[regions.length * point + i] * trace
    }
    for (const [i, own] of links.entries()) own.push({ name: names[target], weight: lost[i] / totals[i] })
  }
  return regions.map(({ name: area }, i) => ({
    type: 'morph',
    area,
    targets: strongest(links[i]),
    rule: 'sum',
    curve: [
      [-PULLED, SMOOTH],
      [0, AT_REST],
      [SQUEEZED, 1],
    ] satisfies Curve,
  }))
}

/** Returns the targets with the largest weights, sorted from large to small. */
function strongest(links: readonly { name: string; weight: number }[]): MorphDriver['targets'] {
  return links
    .filter(({ weight }) => Math.abs(weight) >= NEGLIGIBLE)
    .sort((a, b) => Math.abs(b.weight) - Math.abs(a.weight))
    .slice(0, MAX_TARGETS)
    .map(({ name, weight }) => ({ name, weight: roundWeight(weight) }))
}

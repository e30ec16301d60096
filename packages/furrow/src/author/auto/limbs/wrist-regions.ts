import { Rng } from '../../../math/rng.ts'
import { length } from '../../../math/vector.ts'
import { across, crossed, scale, subtract, unit, type Vector } from '../../../math/vector3.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'
import type { HandJoints } from '../skeleton/humanoid.ts'
import { arcGuides, cylinderChart } from './arcs.ts'
import type { HandFrame } from './hand-frame.ts'
import { WRIST_CREASES } from './hand-tables.ts'
import { guideLayer } from './limb-chart.ts'
import { type LimbSkin, pointWeights } from './limb-skin.ts'
import type { SkinPlan } from './region-plan.ts'
import { DEGREE } from './turn.ts'

/** Activations at rest of the creases inside the wrist and on its back. */
const REST = { inside: 0.35, back: 0.12 } as const
/** Full angles in degrees (American Academy of Orthopaedic Surgeons 1965). */
const RANGES = { flexion: 80, extension: 70 } as const

/** Returns the regions of a wrist: creases inside, which bending deepens, and on the back. */
export function wristRegions(
  limb: LimbSkin,
  { wrist }: HandJoints,
  frame: HandFrame,
  { seed, ageFraction }: { seed: number; ageFraction: number },
): SkinPlan[] {
  const { joints } = limb.skeleton
  const { surface } = limb.prepared
  const from = joints[wrist].parent
  if (from < 0) return []
  const rng = new Rng(seed, `wrist ${joints[wrist].name}`)
  const forearm = subtract(frame.wrist, limb.places[from])
  const size = frame.size.along
  const along = length(forearm) > 20 * size ? unit(forearm) : frame.y
  const palm = across(frame.z, along)
  const on = pointWeights(limb, subtreeOf(joints, from))
  const region = (isInside: boolean): SkinPlan => {
    const front: Vector = isInside ? palm : scale(palm, -1)
    const chart = cylinderChart(
      limb,
      { origin: frame.wrist, axis: along, front },
      (point) => on[point] > 0.5,
      size,
    )
    const arcs = isInside ? WRIST_CREASES.inside : WRIST_CREASES.back
    const guides = arcGuides(chart, arcs, size, rng, { taper: [0.2125, 0.2125] })
    const axis = crossed(along, front)
    const full = (isInside ? RANGES.flexion : RANGES.extension) * DEGREE
    const turn = { joints: [wrist], from, axis, full }
    return {
      name: `${joints[wrist].name} ${isInside ? 'flexion' : 'extension'}`,
      turn,
      spacing: 7 * size,
      creasedFraction: 0.4 + 0.1 * ageFraction,
      assumedCompression: 0.2,
      maxDepth: size * (isInside ? 1.05 : 0.8) * (0.85 + 0.4 * ageFraction),
      reach: 4.5 * size,
      feather: 5 * size,
      looseness: 12 * size,
      links: [{ turn, rest: isInside ? REST.inside : REST.back, full: 1 }],
      rank: 3.5,
      lay: guideLayer(surface, guides),
    }
  }
  return [region(true), region(false)]
}

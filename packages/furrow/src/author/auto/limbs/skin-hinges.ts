import { Rng } from '../../../math/rng.ts'
import { dot } from '../../../math/vector.ts'
import type { LineStyle } from '../anatomy/region.ts'
import type { HingedLimb } from '../skeleton/humanoid.ts'
import { arcGuides } from './arcs.ts'
import { FLEXION, type Hinged, type HingePlaces, hingeOf, OWN, placesAround, STRAINED } from './hinge.ts'
import { HINGE_CREASES } from './hinge-creases.ts'
import { guideLayer, LimbChart } from './limb-chart.ts'
import type { LimbSkin } from './limb-skin.ts'
import type { SkinPlan } from './region-plan.ts'
import { DEGREE } from './turn.ts'

/** Activation of the flexion creases of a straight limb: they never vanish. */
const REST = 0.3
/** Angle in degrees at which the wrinkles over the tip of the elbow or the kneecap are smooth. */
const SMOOTH = 60
/** Compression of the loose skin on the outside of a straight limb, which is long enough for a bent one. */
const LOOSE = 0.14
/** Distance from the hinge along the limb at which creases are drawn, in millimetres for an adult. */
const EXTENT = 70
/** Normals may point inwards by this cosine, because muscles bulge. */
const OUTWARDS = -0.2
/** Factor on the random variation of creases, compared with those of fingers. */
const VARIED = 3
/** Style of wrinkles on the outside, which are shallow and have no clear ends. */
const BACK_STYLE: Partial<LineStyle> = {
  depths: [0.4, 0.85, 1, 0.85, 1, 0.9, 0.4],
  taper: [0.25, 0.25],
  shoulder: [0.9, 0.9],
  softness: 0.85,
}

/** Returns the regions of bare skin at elbows and knees: creases in the crook, and wrinkles on the outside of a straight limb. */
export function skinHinges(
  limb: LimbSkin,
  limbs: readonly HingedLimb[],
  settings: { seed: number; ageFraction: number },
): SkinPlan[] {
  return limbs.flatMap((joints) => {
    const hinged = hingeOf(limb, joints)
    const around = hinged && placesAround(limb, hinged)
    return around ? regionsOf(limb, hinged, around, settings) : []
  })
}

function regionsOf(
  limb: LimbSkin,
  hinged: Hinged,
  around: HingePlaces,
  { seed, ageFraction }: { seed: number; ageFraction: number },
): SkinPlan[] {
  const { kind, hinge, axis, lengths } = hinged
  const { surface } = limb.prepared
  const { joints } = limb.skeleton
  const { crook, back, depth, length } = HINGE_CREASES[kind]
  const size = (lengths[0] + lengths[1]) / length
  const rng = new Rng(seed, `skin ${joints[hinge].name}`)
  const turn = { joints: [hinge], from: joints[hinge].parent, axis, full: FLEXION[kind] * DEGREE }
  const name = joints[hinge].name
  const shared = { turn, strained: STRAINED, looseness: 0.5 * around.radius, feather: 9 * size }
  const inside = arcGuides(chartOf(limb, around, 0, size), crook, size, rng, {}, VARIED)
  const outside = arcGuides(chartOf(limb, around, Math.PI, size), back, size, rng, BACK_STYLE, VARIED)
  return [
    {
      ...shared,
      name: `${name} flexion`,
      spacing: 11 * size,
      creasedFraction: 0.45 + 0.1 * ageFraction,
      assumedCompression: 0.3,
      maxDepth: size * depth.crook * (0.9 + 0.4 * ageFraction),
      reach: 7 * size,
      links: [{ turn, rest: REST, full: 1 }],
      pair: `${kind} crook`,
      rank: 3.8,
      lay: guideLayer(surface, inside),
    },
    {
      ...shared,
      name: `${name} extension`,
      spacing: 6 * size,
      creasedFraction: 0.4 + 0.15 * ageFraction,
      assumedCompression: LOOSE,
      maxDepth: size * depth.back * (0.7 + 0.8 * ageFraction),
      reach: 5 * size,
      links: [{ turn: { ...turn, full: SMOOTH * DEGREE }, rest: 0.8, full: 0 }],
      pair: `${kind} back`,
      rank: 1.8,
      lay: guideLayer(surface, outside),
    },
  ]
}

/** Returns the cylinder around the limb as a chart, whose angle is 0 at the given angle from the crook. */
function chartOf(limb: LimbSkin, { on, places }: HingePlaces, front: number, size: number): LimbChart {
  const { surface } = limb.prepared
  return new LimbChart(
    surface,
    (point) => {
      const { angle, along } = places[point]
      const turned = angle - front
      return Math.abs(along) < EXTENT * size
        ? [turned < -Math.PI ? turned + 2 * Math.PI : turned, along]
        : undefined
    },
    (normal, point) => on[point] > OWN && dot(normal, places[point].away) > OUTWARDS * places[point].radius,
    2 * Math.PI,
  )
}

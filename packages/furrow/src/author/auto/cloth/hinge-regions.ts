import { Rng } from '../../../math/rng.ts'
import { clamp, fadeOut, smoothstep } from '../../../math/scalar.ts'
import {
  FLEXION,
  type Hinged,
  type HingePlaces,
  hingeOf,
  OWN,
  placesAround,
  STRAINED,
} from '../limbs/hinge.ts'
import type { LimbSkin } from '../limbs/limb-skin.ts'
import type { RegionPlan } from '../limbs/region-plan.ts'
import { DEGREE } from '../limbs/turn.ts'
import type { HingedLimb } from '../skeleton/humanoid.ts'
import { CLOTHS, type ClothKind } from './cloth-kinds.ts'
import { foldPlan } from './lay-folds.ts'
import { crushMask, hemMask } from './masks.ts'
import { tensionLines } from './tension-lines.ts'

/** Angle from the crook, in degrees, up to which the cloth folds completely, and at which the folds end: at the tip of the elbow. */
const AROUND = [112, 166] as const
/** Length of the folded part in radii of the tube, on both sides of the hinge. */
const ALONG = [2.1, 3.2] as const
/** Fraction of the upper and the lower half that may fold. */
const HALVES = [0.72, 0.8] as const
/** Spread of the folds from the crook: they lean away from the hinge towards the tip of the elbow or the front of the knee. */
const FAN = 0.3
/** Fraction of the compression that acts along the limb. Cloth slides around a limb more easily than it shears. */
const DIRECTED = 0.55
/** Minimum length of a fold in wavelengths. */
const SHORTEST = 1.1
/** Number of samples of the cloth per wavelength. */
const SAMPLES = 9
/** Standard deviation of the random turn of the compression, as a slope. */
const LEAN = 0.34
/** Compression at which the cloth buckles. */
const CRITICAL = 0.06
/** Standard deviation of the logarithm of a fold's share of the compression. */
const UNEVENNESS = 0.75
/** Share of a limb's own joints from which on cloth begins to belong to the limb. */
const FROM = 0.35
/** Maximum angle around the limb without cloth, in radians. A skirt covers only the outer side of each leg. */
const MAX_GAP = 130 * DEGREE

/** Returns the regions of cloth at elbows and knees. */
export function hingeRegions(
  limb: LimbSkin,
  limbs: readonly HingedLimb[],
  { seed, strength, cloth }: { seed: number; strength: number; cloth: ClothKind },
): RegionPlan[] {
  const hem = hemMask(limb.prepared.surface)
  return limbs.flatMap((joints) => {
    const hinged = hingeOf(limb, joints)
    return hinged ? (regionOf(limb, hinged, hem, { seed, strength, cloth }) ?? []) : []
  })
}

function regionOf(
  limb: LimbSkin,
  hinged: Hinged,
  hem: (point: number) => number,
  { seed, strength, cloth }: { seed: number; strength: number; cloth: ClothKind },
): RegionPlan | undefined {
  const { kind, hinge, axis, lengths } = hinged
  const { joints } = limb.skeleton
  const around = placesAround(limb, hinged)
  if (!around || !isTube(around, hinged)) return undefined
  const { on, places, radius } = around
  const { looseness, wavelength } = CLOTHS[cloth]
  const turn = { joints: [hinge], from: joints[hinge].parent, axis, full: FLEXION[kind] * DEGREE }
  const ends = [-HALVES[0] * lengths[0], HALVES[1] * lengths[1]]
  const weight = (point: number) => {
    if (on[point] < FROM) return 0
    const { angle, along, radius: away } = places[point]
    if (along < ends[0] || along > ends[1] || away > 2.2 * radius) return 0
    const far = Math.abs(along) / radius
    return (
      fadeOut(Math.abs(angle) / DEGREE, AROUND) *
      fadeOut(far, ALONG) *
      smoothstep((on[point] - FROM) / (OWN - FROM)) *
      smoothstep((along - ends[0]) / wavelength) *
      smoothstep((ends[1] - along) / wavelength) *
      hem(point)
    )
  }
  const crushed = crushMask(limb, turn, STRAINED)
  const tube = {
    place: (point: number) => {
      const { angle, along } = places[point]
      return [angle, along] as const
    },
    radius,
    weight,
    shown: (point: number) => crushed[point],
    wavelength,
    samples: SAMPLES,
    shortest: SHORTEST,
    directed: DIRECTED,
    lean: LEAN,
    critical: CRITICAL,
    unevenness: UNEVENNESS,
    ragged: 0,
    fan: (angle: number, along: number) =>
      (-FAN * (along / radius) * smoothstep((Math.PI - Math.abs(angle)) / 0.8) * clamp(angle / 0.2, -1, 1)) /
      (1 + FAN * Math.abs(angle)),
    seed: new Rng(seed, `cloth ${joints[hinge].name}`).integer(),
  }
  return {
    name: `${joints[hinge].name} flexion`,
    turn,
    ...foldPlan(limb, tube, strength, tensionLines),
    looseness: looseness * radius,
    strained: STRAINED,
    links: [{ turn, rest: 0, full: 1 }],
    pair: kind,
    rank: 6,
  }
}

/** Returns whether the cloth at a hinge surrounds the limb. A skirt hangs around both legs, so the flexion of one knee does not compress it. */
function isTube({ on, places, radius }: HingePlaces, { lengths }: Hinged): boolean {
  const reach = Math.min(radius, ...lengths)
  const angles = places
    .filter(({ along }, point) => on[point] > OWN && Math.abs(along) < reach)
    .map(({ angle }) => angle)
    .sort((a, b) => a - b)
  const gaps = angles.map((angle, i) => (angles[i + 1] ?? angles[0] + 2 * Math.PI) - angle)
  return Math.max(...gaps) < MAX_GAP
}

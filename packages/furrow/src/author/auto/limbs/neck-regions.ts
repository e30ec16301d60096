import { cos, sin } from '../../../math/elementary.ts'
import { Rng } from '../../../math/rng.ts'
import { fadeOut, lerp, smoothstep } from '../../../math/scalar.ts'
import { dot, length } from '../../../math/vector.ts'
import { across, crossed, subtract, unit, type Vector, vectorAt } from '../../../math/vector3.ts'
import { type LineStyle, SIDES } from '../anatomy/region.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'
import type { NeckJoints } from '../skeleton/humanoid.ts'
import { aroundLimb } from './limb-chart.ts'
import { layLimbFilm } from './limb-film.ts'
import { type LimbSkin, pointWeights } from './limb-skin.ts'
import type { SkinPlan } from './region-plan.ts'
import { DEGREE } from './turn.ts'

/** Full angles in degrees (American Academy of Orthopaedic Surgeons 1965), limited to what skeletons show without collapsing. */
const RANGES = { bend: 45, turn: 60, tilt: 40 } as const

/** Where the skin of the neck folds in one direction of the head, and how. */
interface NeckFold {
  name: string
  /** Axis of the turn: direction in the frame of the neck to the left, up and to the front. */
  axis: readonly [left: number, up: number, front: number]
  degrees: number
  /** Angle from the front towards the person's left around which the folds lie, and half of the angle that they span, in degrees. */
  middle: number
  span: number
  /** Direction across the folds, around the neck towards the person's left, and upwards. */
  pull: readonly [around: number, along: number]
  /** Thickness of the dermis in millimetres at 20 and at 80 years. */
  thickness: readonly [at20: number, at80: number]
  /** Depth limit in millimetres at 20 and at 80 years. */
  depth: readonly [at20: number, at80: number]
  width: number
  softness: number
  rest: number
}

const FOLDS: readonly NeckFold[] = [
  {
    name: 'forward',
    axis: [1, 0, 0],
    degrees: RANGES.bend,
    middle: 0,
    span: 78,
    pull: [0, 1],
    thickness: [1.0, 0.85],
    depth: [1.3, 1.9],
    width: 3.4,
    softness: 0.45,
    rest: 0.22,
  },
  {
    name: 'back',
    axis: [-1, 0, 0],
    degrees: RANGES.bend,
    middle: 180,
    span: 82,
    pull: [0, 1],
    thickness: [1.6, 1.4],
    depth: [1.9, 2.5],
    width: 8,
    softness: 0.8,
    rest: 0,
  },
  ...SIDES.map(
    ([side, name]): NeckFold => ({
      name: `turn to the ${name.toLowerCase()}`,
      axis: [0, side, 0],
      degrees: RANGES.turn,
      middle: 54 * side,
      span: 64,
      pull: [0.6 * side, -0.8],
      thickness: [1.05, 0.85],
      depth: [1.5, 2],
      width: 3.6,
      softness: 0.5,
      rest: 0,
    }),
  ),
  ...SIDES.map(
    ([side, name]): NeckFold => ({
      name: `tilt to the ${name.toLowerCase()}`,
      axis: [0, 0, -side],
      degrees: RANGES.tilt,
      middle: 88 * side,
      span: 62,
      pull: [0.2 * side, 0.98],
      thickness: [1.2, 1],
      depth: [1.4, 1.9],
      width: 3.8,
      softness: 0.5,
      rest: 0,
    }),
  ),
]

const STYLE: Omit<LineStyle, 'width' | 'softness'> = {
  depth: 1,
  taper: [0.255, 0.255],
  shoulder: [0.95, 0.95],
}

/** The skin folds where the cosine between its normal and the direction out of the neck rises from the first value to the second. */
const FACING = [0.35, 0.65] as const
/** Weight of the joints above the base of the neck at which the folds begin, and at which they are complete. */
const MOVED = [0.04, 0.16] as const
/** Weight of the head alone at which the folds fade out, and at which they end. */
const ON_HEAD = [0.5, 0.85] as const

/** Returns the regions of a neck, one for each direction in which the head moves. */
export function neckRegions(
  limb: LimbSkin,
  { base, chain }: NeckJoints,
  { seed, ageFraction }: { seed: number; ageFraction: number },
): SkinPlan[] {
  const { joints } = limb.skeleton
  const { surface } = limb.prepared
  const { points, normals } = surface
  const head = chain[chain.length - 1]
  const first = limb.places[chain[0]]
  const below = chain.length > 1 ? first : limb.places[base]
  const span = subtract(limb.places[head], below)
  if (!(length(span) > 0)) return []
  const up = unit(span)
  const left = across(limb.left, up)
  const front = crossed(left, up)
  const moved = pointWeights(limb, subtreeOf(joints, chain[0]))
  const above = pointWeights(limb, subtreeOf(joints, head))
  const at = (i: number) => vectorAt(points, i)
  const frame = { origin: first, axis: up, front }
  const skin = Array.from(surface.areas, (_, i) => {
    if (moved[i] < MOVED[0] || above[i] > ON_HEAD[1]) return undefined
    const { angle, along, radius } = aroundLimb(frame, at(i))
    const facing = dot(vectorAt(normals, i), across(subtract(at(i), first), up))
    const weight =
      smoothstep((facing - FACING[0]) / (FACING[1] - FACING[0])) *
      smoothstep((moved[i] - MOVED[0]) / (MOVED[1] - MOVED[0])) *
      fadeOut(above[i], ON_HEAD)
    return weight > 0 ? { angle, along, radius, weight } : undefined
  })
  const radii = skin.flatMap((found) => found?.radius ?? []).sort((a, b) => a - b)
  if (radii.length === 0) return []
  const radius = radii[Math.floor(radii.length / 2)]
  return FOLDS.map((fold, i): SkinPlan => {
    const [x, y, z] = fold.axis
    const axis: Vector = unit([0, 1, 2].map((k) => x * left[k] + y * up[k] + z * front[k]))
    const turn = { joints: chain.slice(-6), from: base, axis, full: fold.degrees * DEGREE }
    const middle = fold.middle * DEGREE
    // The chart of each fold begins opposite of its middle, so that no fold crosses the chart's border.
    const ownFront = rotatedAbout(up, front, middle)
    const ownFrame = { origin: first, axis: up, front: ownFront }
    const thickness = lerp(...fold.thickness, ageFraction)
    const size = radius / 58
    const weight = (point: number) => {
      const found = skin[point]
      if (!found) return 0
      const { angle } = aroundLimb(ownFrame, at(point))
      return found.weight * (1 - smoothstep((Math.abs(angle) / (fold.span * DEGREE) - 0.55) / 0.45))
    }
    const spacing = 13.5 * thickness * size
    const film = {
      frame: ownFrame,
      radius,
      weight,
      thickness: thickness * size,
      pull: fold.pull,
      directed: 0.7,
      added: 0.05,
      seed: new Rng(seed, `neck ${i}`).integer(),
      style: { ...STYLE, width: size * fold.width, softness: fold.softness },
    }
    const creasedFraction = 0.45 + 0.15 * ageFraction
    return {
      name: `${joints[head].name} ${fold.name}`,
      turn,
      spacing,
      creasedFraction,
      maxDepth: size * lerp(...fold.depth, ageFraction),
      reach: 0.45 * spacing,
      feather: 0.7 * spacing,
      looseness: 0.4 * radius,
      links: [{ turn, rest: fold.rest, full: 1 }],
      rank: 5,
      lay: (tensors) => layLimbFilm(surface, film, tensors, creasedFraction),
    }
  })
}

function rotatedAbout(axis: Vector, v: Vector, angle: number): Vector {
  const side = crossed(axis, v)
  const [c, s] = [cos(angle), sin(angle)]
  return [c * v[0] + s * side[0], c * v[1] + s * side[1], c * v[2] + s * side[2]]
}

import { Rng } from '../../../math/rng.ts'
import { fadeOut, lerp } from '../../../math/scalar.ts'
import { length } from '../../../math/vector.ts'
import { across, crossed, scale, subtract, unit, type Vector, vectorAt } from '../../../math/vector3.ts'
import { CLOTHS, type ClothKind } from '../cloth/cloth-kinds.ts'
import { foldPlan } from '../cloth/lay-folds.ts'
import { crushMask, hemMask } from '../cloth/masks.ts'
import { aroundLimb, type LimbFrame } from '../limbs/limb-chart.ts'
import { layLimbFilm } from '../limbs/limb-film.ts'
import { type LimbSkin, pointWeights } from '../limbs/limb-skin.ts'
import { widened } from '../limbs/observed.ts'
import type { RegionPlan, SkinPlan } from '../limbs/region-plan.ts'
import { DEGREE, type JointTurn } from '../limbs/turn.ts'
import { type ChainBend, findBends } from '../skeleton/chains.ts'
import { subtreeOf } from '../skeleton/hierarchy.ts'

/** Full angle in degrees of a joint that no animation turns. */
const CONE = 60
/** Smallest angle in degrees that an animation must show in a direction. */
const LEAST = 8
/** Share of the chain's own joints from which on a point belongs to the tube. */
const OWN = 0.6
/** A tube has points in all sectors around its axis, and its radius varies at most by this fraction. */
const SECTORS = 8
const UNEVEN = 0.3
/** Angles from the crook, in degrees, up to which the tube folds completely, and at which the folds end. */
const AROUND = [60, 120] as const
/** Distances from the joint, as fractions of the shorter bone, up to which the tube folds completely, and at which the folds end. */
const ALONG = [0.55, 1] as const
/** Fraction of the full angle at which the strain is measured. */
const STRAINED = 0.8
/** Properties of the skin of a tube whose radius is that of a neck, in millimetres at 20 and at 80 years. */
const SKIN = { radius: 58, thickness: [1.3, 1.1], depth: [1.4, 2], width: 4 } as const

/** Tube around a joint of a chain. Lengths are in millimetres. */
interface Tube extends ChainBend {
  frame: LimbFrame
  radius: number
  /** Weight of the folds along the tube at each point, 0..1. */
  along: Float64Array
}

/** Settings of tubes. */
interface TubeSettings {
  seed: number
  ageFraction: number
  strength: number
}

/** Returns the regions of skin around the joints of chains: one per direction in which a joint bends. */
export function skinTubes(limb: LimbSkin, { seed, ageFraction }: TubeSettings): SkinPlan[] {
  return tubesOf(limb).flatMap((tube) => {
    const size = tube.radius / SKIN.radius
    const thickness = size * lerp(...SKIN.thickness, ageFraction)
    const spacing = 13.5 * thickness
    const creasedFraction = 0.45 + 0.15 * ageFraction
    return turnsOf(limb, tube).map(({ name, turn, frame, weight }): SkinPlan => {
      const film = {
        frame,
        radius: tube.radius,
        weight,
        thickness,
        pull: [0, 1] as const,
        directed: 0.7,
        added: 0.05,
        seed: new Rng(seed, `tube ${name}`).integer(),
        style: {
          depth: 1,
          taper: [0.25, 0.25],
          shoulder: [0.9, 0.9],
          width: SKIN.width * size,
          softness: 0.55,
        } as const,
      }
      return {
        ...sharedPlan(tube, name, turn),
        spacing,
        creasedFraction,
        maxDepth: size * lerp(...SKIN.depth, ageFraction),
        reach: 0.45 * spacing,
        feather: 0.7 * spacing,
        looseness: 0.5 * tube.radius,
        lay: (tensors) => layLimbFilm(limb.prepared.surface, film, tensors, creasedFraction),
      }
    })
  })
}

/** Returns the regions of cloth around the joints of chains: one per direction in which a joint bends. */
export function clothTubes(limb: LimbSkin, cloth: ClothKind, { seed, strength }: TubeSettings): RegionPlan[] {
  const hem = hemMask(limb.prepared.surface)
  const { wavelength, looseness } = CLOTHS[cloth]
  return tubesOf(limb).flatMap((tube) =>
    turnsOf(limb, tube).map(({ name, turn, frame, weight }): RegionPlan => {
      const crushed = crushMask(limb, turn, STRAINED)
      const film = {
        place: (point: number) => {
          const { angle, along } = aroundLimb(frame, vectorAt(limb.prepared.surface.points, point))
          return [angle, along] as const
        },
        radius: tube.radius,
        weight: (point: number) => weight(point) * hem(point),
        shown: (point: number) => crushed[point],
        wavelength,
        samples: 9,
        shortest: 1.1,
        fan: () => 0,
        directed: 0.55,
        lean: 0.3,
        critical: 0.06,
        unevenness: 0.75,
        ragged: 0,
        seed: new Rng(seed, `tube ${name}`).integer(),
      }
      return {
        ...sharedPlan(tube, name, turn),
        ...foldPlan(limb, film, strength),
        looseness: looseness * tube.radius,
      }
    }),
  )
}

function sharedPlan({ radius }: Tube, name: string, turn: JointTurn) {
  return { name, turn, strained: STRAINED, links: [{ turn, rest: 0, full: 1 }], rank: radius }
}

/** Returns the tubes around the joints of chains. Joints whose skin is not tubular have none. */
function tubesOf(limb: LimbSkin): Tube[] {
  return findBends(limb.skeleton).flatMap((bend) => tubeAt(limb, bend) ?? [])
}

function tubeAt(limb: LimbSkin, bend: ChainBend): Tube | undefined {
  const [above, place, below] = [bend.above, bend.joint, bend.below].map((joint) => limb.places[joint])
  const shorter = Math.min(length(subtract(place, above)), length(subtract(below, place)))
  if (!(shorter > 0)) return undefined
  const axis = unit(subtract(below, above))
  const frame = { origin: place, axis, front: across(Math.abs(axis[1]) < 0.8 ? [0, 1, 0] : [0, 0, 1], axis) }
  const { points } = limb.prepared.surface
  const own = pointWeights(limb, subtreeOf(limb.skeleton.joints, bend.above))
  const places = Array.from(own, (_, point) => aroundLimb(frame, vectorAt(points, point)))
  const near = places.filter(({ along }, point) => own[point] > OWN && Math.abs(along) < ALONG[0] * shorter)
  const sectors = new Set(
    near.map(({ angle }) => Math.floor(((angle / Math.PI + 1) * SECTORS) / 2) % SECTORS),
  )
  const radii = near.map(({ radius }) => radius).sort((a, b) => a - b)
  const at = (share: number) => radii[Math.round(share * (radii.length - 1))]
  if (sectors.size < SECTORS || at(0.9) - at(0.1) > 2 * UNEVEN * at(0.5)) return undefined
  const along = Float64Array.from(own, (weight, point) =>
    weight > OWN && places[point].radius < 2 * at(0.5)
      ? fadeOut(Math.abs(places[point].along) / shorter, ALONG)
      : 0,
  )
  return { ...bend, frame, radius: at(0.5), along }
}

/** Returns the directions in which a joint bends, with the weight of the folds at each point. */
function turnsOf(limb: LimbSkin, { joint, above, frame, along }: Tube) {
  const { name, rotations = [] } = limb.skeleton.joints[joint]
  const { points } = limb.prepared.surface
  const side = crossed(frame.axis, frame.front)
  const fronts: Vector[] = [frame.front, side, scale(frame.front, -1), scale(side, -1)]
  return fronts.flatMap((front, i) => {
    // A positive rotation bends the tube towards the front.
    const turn = { joints: [joint], from: above, axis: crossed(frame.axis, front), full: LEAST * DEGREE }
    const seen = widened(limb, turn)
    if (rotations.length > 0 && seen === turn) return []
    const own = { ...frame, front }
    const weight = (point: number) => {
      if (!(along[point] > 0)) return 0
      const { angle } = aroundLimb(own, vectorAt(points, point))
      return along[point] * fadeOut(Math.abs(angle) / DEGREE, AROUND)
    }
    const full = rotations.length > 0 ? seen : { ...turn, full: CONE * DEGREE }
    return [{ name: `${name} bend ${i + 1}`, turn: full, frame: own, weight }]
  })
}

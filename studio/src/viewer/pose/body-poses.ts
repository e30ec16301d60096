import type { Area, ArraySlice, WrinkleDriver } from 'furrow'
import { driversOf } from 'furrow'
import type { Skin } from 'furrow/author'
import {
  type AreaPlace,
  type AreaView,
  isFolding,
  type JointRotation,
  type LimbJoints,
  limbsOf,
  placeOfArea,
  poseOfDriver,
  viewOfPlace,
} from 'furrow/internal'

/** Pose of joints that folds one or several areas. */
export interface BodyPose {
  /** Part of the body and, if it can move in several ways, its movement: `left elbow`, `left fist`, `neck forward`. */
  readonly name: string
  /** Names of the areas that the pose folds. */
  readonly areas: readonly string[]
  /** Rotation of each turned joint from its rest pose, at the full angle. The keys are names in the file. */
  readonly joints: ReadonlyMap<string, JointRotation>
  /** Returns where the folds are, in world space in the rest pose. */
  place(): AreaPlace
  /** Returns a view of the folds and the limb around them. */
  view(): AreaView
}

/** Least height of a view, metres. A smaller part of the body cannot be recognised. */
const LEAST_HEIGHT = 0.22

/** Weights of areas. The keys are their names. Slices of KTX 2 files cannot be read. */
export type AreaWeights = ReadonlyMap<string, Area<ArraySlice>['weights']>

type Posed = ReturnType<typeof poseOfDriver> & { area: string; name: string }

/** Returns the poses in which joints fold the areas of a skin. Areas of one hand or joint share a pose. */
export function bodyPoses(
  skin: Skin,
  drivers: readonly WrinkleDriver[],
  weights: AreaWeights,
): readonly BodyPose[] {
  const joints = skin.skeleton?.joints ?? []
  const limbs = limbsOf(skin)
  const posed = driversOf('bone', drivers).flatMap((driver): Posed[] => {
    const pose = weights.has(driver.area) && isFolding(driver) ? poseOfDriver(joints, driver, 1) : undefined
    return pose ? [{ ...pose, area: driver.area, name: nameOf(driver.area, pose.joint, limbs) }] : []
  })
  const names = [...new Set(posed.map(({ name }) => name))]
  return names.map((name) => {
    const group = posed.filter((pose) => pose.name === name)
    let found: AreaPlace | undefined
    const place = () => {
      found ??= placeOf(skin, group, weights)
      return found
    }
    const view = () => {
      const near = viewOfPlace(place())
      return { ...near, height: Math.max(near.height, LEAST_HEIGHT) }
    }
    const areas = [...new Set(group.map(({ area }) => area))]
    return { name, areas, joints: widest(group), place, view }
  })
}

/** Returns the rotations of a single area. */
export function jointsOfArea(
  skin: Skin,
  drivers: readonly WrinkleDriver[],
  area: string,
  fraction: number,
): ReadonlyMap<string, JointRotation> {
  const own = driversOf('bone', drivers).filter((driver) => driver.area === area && isFolding(driver))
  return widest(own.flatMap((driver) => poseOfDriver(skin.skeleton?.joints ?? [], driver, fraction) ?? []))
}

/** Movement at the end of the name of an area, for limbs that move in several ways. */
const MOVEMENT = /(forward|back|extension|(?:turn|tilt) to the (?:left|right)|bend \d+)$/

function nameOf(area: string, joint: string, limbs: readonly LimbJoints[]): string {
  const { limb, joints } = limbs.find(({ joints }) => joints.includes(joint)) ?? {}
  const movement = MOVEMENT.exec(area)?.[1]
  const withMovement = (part: string) => (movement ? `${part} ${movement}` : part)
  if (!limb || !joints || limb === 'chain') return withMovement(joint)
  if (limb === 'neck' || limb === 'waist') return withMovement(limb)
  if (!limb.endsWith('hand')) return limb
  // The first joint of a hand is the wrist.
  if (joint !== joints[0]) return limb.replace(/hand$/, 'fist')
  return limb.replace(/hand$/, movement === 'extension' ? 'wrist back' : 'wrist')
}

/** Joins rotations. If several turn a joint, keeps the largest. */
function widest(poses: readonly { joints: Record<string, JointRotation> }[]): Map<string, JointRotation> {
  const joined = new Map<string, JointRotation>()
  for (const [name, rotation] of poses.flatMap(({ joints }) => Object.entries(joints))) {
    const known = joined.get(name)
    if (!known || Math.abs(rotation[3]) < Math.abs(known[3])) joined.set(name, rotation)
  }
  return joined
}

/** Returns where a pose folds the skin: at its first area, with a size that includes all turned joints of a hand. */
function placeOf(skin: Skin, group: readonly Posed[], weights: AreaWeights): AreaPlace {
  const image = weights.get(group[0].area)
  const place = image && 'data' in image ? placeOfArea(skin, image) : undefined
  const joints = [...new Set(group.map(({ joint }) => joint))]
  const points = joints.flatMap((name) => {
    const bind = skin.skeleton!.joints.find((joint) => joint.name === name)?.bind
    return bind ? [[bind[12], bind[13], bind[14]] as const] : []
  })
  const [x, y, z] = [0, 1, 2].map((k) => points.reduce((sum, point) => sum + point[k] / points.length, 0))
  const spread = Math.sqrt(
    points.reduce((sum, p) => sum + ((p[0] - x) ** 2 + (p[1] - y) ** 2 + (p[2] - z) ** 2) / points.length, 0),
  )
  if (place && spread <= place.size) return place
  return { middle: [x, y, z], normal: place?.normal ?? [0, 0, 1], size: spread }
}

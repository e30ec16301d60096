import type { GrayImage } from '../../../core/types.ts'
import type { BoneDriver } from '../../../drivers/bone/definition.ts'
import { atan2, cos, sin } from '../../../math/elementary.ts'
import { clamp } from '../../../math/scalar.ts'
import { triangleNormal } from '../../../math/triangle.ts'
import { dot, length, length2 } from '../../../math/vector.ts'
import type { SkinJoint } from '../../skin/skeleton.ts'
import type { Skin } from '../../skin/surface.ts'
import { DEGREE } from '../limbs/turn.ts'

/** Rotation of a joint from its rest pose, in the joint's own frame: a unit quaternion. */
export type JointRotation = readonly [x: number, y: number, z: number, w: number]

/** Fraction of the full angle at which folds show best. At larger angles, a limb hides its crook. */
export const BENT = 0.7

/** Pose of joints that folds an area. */
export interface AreaPose {
  /** Rotations of all turned joints. The keys are the names of the joints. */
  joints: Record<string, JointRotation>
  /** Name of the last turned joint. */
  joint: string
  /** Total angle, radians. */
  angle: number
}

/** Returns whether a driver activates its area more, the further a joint turns. */
export function isFolding({ measure, curve }: BoneDriver): boolean {
  return measure === 'angle' && curve[curve.length - 1][1] > curve[0][1]
}

/**
 * Returns the pose in which a driver activates its area. All joints between the two of the driver share the angle.
 *
 * @param joints joints of the skeleton.
 * @param fraction fraction of the angle at which the driver's curve ends.
 * @returns undefined if the skeleton lacks the joint.
 */
export function poseOfDriver(
  joints: readonly SkinJoint[],
  { joints: [from, joint], axis = [0, 0, 1], curve }: BoneDriver,
  fraction = BENT,
): AreaPose | undefined {
  const last = joints.findIndex(({ name }) => name === joint)
  if (last < 0) return undefined
  const chain = chainBelow(joints, from, last)
  const angle = fraction * curve[curve.length - 1][0]
  const world = [0, 1, 2].map((k) =>
    axis.reduce((sum, part, i) => sum + part * columnOf(joints[last], i)[k], 0),
  )
  const half = angle / chain.length / 2
  const rotations = chain.map((turned): [string, JointRotation] => {
    const [x, y, z] = [0, 1, 2].map((i) => dot(columnOf(turned, i), world) * sin(half))
    return [turned.name, [x, y, z, cos(half)]]
  })
  return { joints: Object.fromEntries(rotations), joint, angle }
}

/** Returns the joints below the joint `from`, down to `last`. If `from` is not above `last`, returns only `last`. */
function chainBelow(joints: readonly SkinJoint[], from: string, last: number): SkinJoint[] {
  const chain: SkinJoint[] = []
  for (let at = last; at >= 0; at = joints[at].parent) {
    if (joints[at].name === from) return chain
    chain.unshift(joints[at])
  }
  return [joints[last]]
}

/** Returns a unit vector along an axis of a joint in the bind pose. */
function columnOf({ bind }: SkinJoint, k: number): number[] {
  const column = [bind[4 * k], bind[4 * k + 1], bind[4 * k + 2]]
  const size = length(column) || 1
  return column.map((value) => value / size)
}

type Point = [x: number, y: number, z: number]

/** Position of an area on the skin, in the skin's unit. */
export interface AreaPlace {
  middle: Point
  /** Mean normal; +Z if the area surrounds a limb. */
  normal: Point
  /** Root mean square distance from the middle. */
  size: number
}

/** A mean normal shorter than this has no clear direction. */
const CLEAR = 0.25

/** Returns where an area lies on a skin. Returns undefined if no triangle has weight. */
export function placeOfArea(
  { positions, uvs, indices }: Pick<Skin, 'positions' | 'uvs' | 'indices'>,
  { width, height, data }: GrayImage,
): AreaPlace | undefined {
  const [sum, normals] = [
    [0, 0, 0],
    [0, 0, 0],
  ]
  const cross = new Float64Array(3)
  let [total, squares] = [0, 0]
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const [i, j, k] = [indices[t], indices[t + 1], indices[t + 2]]
    const x = Math.floor(((uvs[2 * i] + uvs[2 * j] + uvs[2 * k]) / 3) * width)
    const y = Math.floor(((uvs[2 * i + 1] + uvs[2 * j + 1] + uvs[2 * k + 1]) / 3) * height)
    const weight = x < 0 || y < 0 || x >= width || y >= height ? 0 : data[y * width + x]
    if (!(weight > 0)) continue
    triangleNormal(cross, positions, i, j, k)
    const share = (weight * length(cross)) / 2
    for (let axis = 0; axis < 3; axis++) {
      const centre = (positions[3 * i + axis] + positions[3 * j + axis] + positions[3 * k + axis]) / 3
      sum[axis] += share * centre
      normals[axis] += (weight * cross[axis]) / 2
      squares += share * centre ** 2
    }
    total += share
  }
  if (!(total > 0)) return undefined
  const middle: Point = [sum[0] / total, sum[1] / total, sum[2] / total]
  const size = length(normals)
  const normal: Point =
    size > CLEAR * total ? [normals[0] / size, normals[1] / size, normals[2] / size] : [0, 0, 1]
  return { middle, normal, size: Math.sqrt(Math.max(0, squares / total - dot(middle, middle))) }
}

/** View of an area from nearby, as in `CloseUp` of the stage. */
export interface AreaView {
  /** Angles of the camera, degrees. */
  yaw: number
  pitch: number
  /** Point in the middle of the picture. */
  point: Point
  /** Height of the picture at the point. */
  height: number
  light: number
}

/** Angle in degrees between the view and the middle of the folds. A limb that bends towards the camera would hide them. */
const ASIDE = 35
/** Height of a picture, relative to the size of the area, and minimum height in metres. */
const FRAME = 5
const MIN_HEIGHT = 0.06
const MAX_PITCH = 50

/** Returns a view that shows an area while joints fold it. */
export function viewOfPlace({ middle, normal, size }: AreaPlace): AreaView {
  const pitch = atan2(normal[1], length2(normal[0], normal[2])) / DEGREE
  const yaw = atan2(normal[0], normal[2]) / DEGREE
  return {
    yaw: yaw > 0 ? yaw - ASIDE : yaw + ASIDE,
    pitch: clamp(pitch, -MAX_PITCH, MAX_PITCH),
    point: middle,
    height: Math.max(MIN_HEIGHT, FRAME * size),
    light: 0,
  }
}

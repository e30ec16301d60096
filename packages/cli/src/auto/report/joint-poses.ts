import type { AutoWrinkles, JointArea, Skin, SkinJoint } from 'furrow/author'
import { dot, triangleNormal } from 'furrow/internal'
import type { FoundSkin } from 'furrow-files'
import type { CloseUpView, JointRotation } from '../../render/picture.ts'

/** Surface with its wrinkles. */
export interface PosedSurface {
  found: Pick<FoundSkin, 'meshName' | 'skin'>
  wrinkles: Pick<AutoWrinkles, 'jointAreas'>
}

/** Pose of joints that folds an area, and a view of this area. */
export interface JointPose {
  /** Name of the area. */
  name: string
  mesh: string
  /** Rotation of each turned joint from its rest pose. */
  joints: Record<string, JointRotation>
  /** Last turned joint, and the total angle in degrees. */
  joint: string
  degrees: number
  view: CloseUpView
}

/** Maximum number of poses. The largest areas come first, because they are most visible. */
const MAX_POSES = 8
/** Fraction of the full angle. At larger angles, a limb hides its crook. */
const BENT = 0.7
/** Angle in degrees between the view and the middle of the folds. A limb that bends towards the camera would hide them. */
const ASIDE = 35
/** Height of a picture, relative to the size of the area, and minimum height in metres. */
const FRAME = 5
const MIN_HEIGHT = 0.06
const MAX_PITCH = 50
const DEGREE = Math.PI / 180

/** Returns the poses that fold the largest areas of a character, without those that a pose smooths. */
export function jointPosesOf(surfaces: readonly PosedSurface[]): JointPose[] {
  const all = surfaces.flatMap(({ found: { meshName, skin }, wrinkles }) =>
    wrinkles.jointAreas.flatMap((area) => {
      const place = placeOf(skin, area)
      return place && isFolding(area) ? [{ place, pose: poseOf(meshName, skin, area, place) }] : []
    }),
  )
  const largest = all.sort((a, b) => b.place.size - a.place.size).slice(0, MAX_POSES)
  return largest.map(({ pose }) => pose)
}

/** Returns whether the activation grows with the angle. */
function isFolding({ drivers: [{ curve }] }: JointArea): boolean {
  return curve[curve.length - 1][1] > curve[0][1]
}

function poseOf(
  mesh: string,
  { skeleton }: Skin,
  area: JointArea,
  { middle, normal, size }: Place,
): JointPose {
  const [{ joints: names, axis = [0, 0, 1], curve }] = area.drivers
  const { joints } = skeleton!
  const [from, last] = names.map((name) => joints.findIndex((joint) => joint.name === name))
  const chain: SkinJoint[] = []
  for (let at = last; at >= 0 && at !== from; at = joints[at].parent) chain.unshift(joints[at])
  const angle = BENT * curve[curve.length - 1][0]
  const world = [0, 1, 2].map((k) =>
    axis.reduce((sum, part, i) => sum + part * columnOf(joints[last], i)[k], 0),
  )
  const half = angle / chain.length / 2
  const rotations = chain.map((joint): [string, JointRotation] => {
    const [x, y, z] = [0, 1, 2].map((i) => dot(columnOf(joint, i), world) * Math.sin(half))
    return [joint.name, [x, y, z, Math.cos(half)]]
  })
  const pitch = Math.asin(normal[1]) / DEGREE
  const yaw = Math.atan2(normal[0], normal[2]) / DEGREE
  return {
    name: area.name,
    mesh,
    joints: Object.fromEntries(rotations),
    joint: joints[last].name,
    degrees: Math.round(angle / DEGREE),
    view: {
      yaw: yaw > 0 ? yaw - ASIDE : yaw + ASIDE,
      pitch: Math.max(-MAX_PITCH, Math.min(MAX_PITCH, pitch)),
      point: middle,
      height: Math.max(MIN_HEIGHT, FRAME * size),
      light: 0,
    },
  }
}

/** Position of an area on the skin, in the skin's unit. */
interface Place {
  middle: [x: number, y: number, z: number]
  /** Mean normal; +Z if the area surrounds a limb. */
  normal: [x: number, y: number, z: number]
  /** Root mean square distance from the middle. */
  size: number
}

/** A mean normal shorter than this has no clear direction. */
const CLEAR = 0.25

function placeOf(
  { positions, uvs, indices }: Skin,
  { weights: { width, height, data } }: JointArea,
): Place | undefined {
  const [sum, normals] = [
    [0, 0, 0],
    [0, 0, 0],
  ]
  const cross = new Float64Array(3)
  let [total, squares] = [0, 0]
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const corners = [indices[t], indices[t + 1], indices[t + 2]]
    const [u, v] = [0, 1].map((k) => corners.reduce((all, i) => all + uvs[2 * i + k] / 3, 0))
    const [x, y] = [Math.floor(u * width), Math.floor(v * height)]
    const weight = x < 0 || y < 0 || x >= width || y >= height ? 0 : data[y * width + x]
    if (!(weight > 0)) continue
    const [a, b, c] = corners.map((i) => [0, 1, 2].map((k) => positions[3 * i + k]))
    triangleNormal(cross, positions, indices[t], indices[t + 1], indices[t + 2])
    const share = (weight * Math.hypot(...cross)) / 2
    const centre = a.map((value, k) => (value + b[k] + c[k]) / 3)
    for (let k = 0; k < 3; k++) {
      sum[k] += share * centre[k]
      normals[k] += (weight * cross[k]) / 2
      squares += share * centre[k] ** 2
    }
    total += share
  }
  if (!(total > 0)) return undefined
  const middle = sum.map((value) => value / total)
  const length = Math.hypot(...normals)
  const normal = length > CLEAR * total ? normals.map((value) => value / length) : [0, 0, 1]
  const size = Math.sqrt(Math.max(0, squares / total - dot(middle, middle)))
  return { middle: [middle[0], middle[1], middle[2]], normal: [normal[0], normal[1], normal[2]], size }
}

/** Returns a unit vector along an axis of a joint in the bind pose. */
function columnOf({ bind }: SkinJoint, k: number): number[] {
  const column = [bind[4 * k], bind[4 * k + 1], bind[4 * k + 2]]
  const length = Math.hypot(...column) || 1
  return column.map((value) => value / length)
}

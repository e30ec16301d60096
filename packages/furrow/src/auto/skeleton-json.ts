import type { SkinJoint } from '../author/skin/skeleton.ts'
import { humanBonesOf } from './human-bones.ts'

/** Maximum number of rotations per joint that are read from animations. Longer animations are sampled. */
const MAX_ROTATIONS = 256

/** Parts of the JSON of a glTF file that describe skeletons and their motion. Malformed parts are ignored. */
export interface SkeletonJson {
  nodes?: readonly NodeJson[] | undefined
  skins?: readonly { joints: readonly number[] }[] | undefined
  animations?: readonly object[] | undefined
  extensions?: object | undefined
}

interface NodeJson {
  name?: string
  children?: readonly number[]
  rotation?: readonly number[]
  /** Column-major 4 x 4 matrix. */
  matrix?: readonly number[]
}

/** Channel of an animation that rotates a node. */
export interface RotationChannel {
  /** Index of the node. */
  node: number
  /** Index of the accessor with the rotations. */
  output: number
  interpolation: string
}

interface AnimationJson {
  channels?: {
    sampler?: number
    target?: { node?: number; path?: string; extensions?: Record<string, { pointer?: unknown }> }
  }[]
  samplers?: { output?: number; interpolation?: string }[]
}

/** Lists the channels of animations that rotate nodes, also those that name the node by `KHR_animation_pointer`. */
export function rotationChannels({ animations = [] }: SkeletonJson): RotationChannel[] {
  return (animations as readonly AnimationJson[]).flatMap(({ channels = [], samplers = [] }) =>
    channels.flatMap(({ sampler = -1, target }) => {
      const pointer = target?.extensions?.KHR_animation_pointer?.pointer
      const pointed = /^\/nodes\/(\d+)\/rotation$/.exec(String(pointer))?.[1]
      const node = target?.path === 'rotation' ? target.node : pointed && Number(pointed)
      const { output, interpolation = 'LINEAR' } = samplers[sampler] ?? {}
      return typeof node === 'number' && output !== undefined ? [{ node, output, interpolation }] : []
    }),
  )
}

/**
 * Reads the rotations of key frames.
 *
 * @param count number of elements in the accessor.
 * @param read returns an element of the accessor: a quaternion (x, y, z, w).
 */
export function keyRotations(
  interpolation: string,
  count: number,
  read: (index: number) => number[],
): number[][] {
  // A cubic spline stores two tangents with each rotation.
  const [step, first] = interpolation === 'CUBICSPLINE' ? [3, 1] : [1, 0]
  const keys = Math.floor(count / step)
  const every = Math.max(1, Math.ceil(keys / MAX_ROTATIONS))
  const rotations: number[][] = []
  for (let key = 0; key < keys; key += every) rotations.push(read(step * key + first))
  return rotations
}

/** Returns the joints of a skin, as indices of nodes. Returns an empty list if the skin does not exist. */
export function jointNodes({ skins = [] }: SkeletonJson, skin: number): readonly number[] {
  return skins[skin]?.joints ?? []
}

/**
 * Describes the joints of a skin.
 *
 * @param skin index of the skin.
 * @param binds for each joint, the column-major 4 x 4 matrix from the joint to the space of the surface, in the bind pose.
 * @param rotations rotations that animations give each node: quaternions (x, y, z, w), by index of the node.
 */
export function skinJoints(
  json: SkeletonJson,
  skin: number,
  binds: readonly ArrayLike<number>[],
  rotations: ReadonlyMap<number, readonly number[][]>,
): SkinJoint[] {
  const { nodes = [] } = json
  const joints = jointNodes(json, skin)
  const parents = parentsOf(nodes)
  const bones = humanBonesOf(json)
  return joints.map((node, i) => {
    const parent = nearestJoint(node, joints, parents)
    // If other nodes lie between a joint and its parent, the bind pose does not tell the rotation of the joint alone.
    const isChild = parent >= 0 && parents.get(node) === joints[parent]
    const rest = isChild
      ? multiply(inverse(rotationIn(binds[parent])), rotationIn(binds[i]))
      : ownRotation(nodes[node])
    const humanBone = bones.get(node)
    return {
      name: nodes[node]?.name || String(node),
      parent,
      bind: binds[i],
      ...(humanBone !== undefined && { humanBone }),
      rotations: Float32Array.from(
        (rotations.get(node) ?? []).flatMap((rotation) => multiply(inverse(rest), rotation)),
      ),
    }
  })
}

function parentsOf(nodes: readonly NodeJson[]): Map<number, number> {
  return new Map(nodes.flatMap(({ children = [] }, parent) => children.map((child) => [child, parent])))
}

/** Returns the index of the nearest ancestor of a node that is a joint; -1 if there is none. */
function nearestJoint(node: number, joints: readonly number[], parents: ReadonlyMap<number, number>): number {
  for (let above = parents.get(node); above !== undefined; above = parents.get(above)) {
    const index = joints.indexOf(above)
    if (index >= 0) return index
  }
  return -1
}

type Quaternion = readonly number[]

function ownRotation({ rotation, matrix }: NodeJson = {}): Quaternion {
  return rotation ?? (matrix ? rotationIn(matrix) : [0, 0, 0, 1])
}

function inverse([x, y, z, w]: Quaternion): number[] {
  return [-x, -y, -z, w]
}

function multiply([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): number[] {
  return [
    ax * bw + aw * bx + ay * bz - az * by,
    ay * bw + aw * by + az * bx - ax * bz,
    az * bw + aw * bz + ax * by - ay * bx,
    aw * bw - ax * bx - ay * by - az * bz,
  ]
}

/** Returns the rotation of a column-major 4 x 4 matrix whose columns may be scaled (Shepperd 1978, Quaternion from rotation matrix). */
function rotationIn(matrix: ArrayLike<number>): number[] {
  const column = (k: number) => {
    const values = [matrix[4 * k], matrix[4 * k + 1], matrix[4 * k + 2]]
    const size = Math.sqrt(values.reduce((sum, value) => sum + value * value, 0))
    return values.map((value) => value / size)
  }
  const [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]] = [column(0), column(1), column(2)]
  // Four times the square of each component. The largest one is the divisor, which keeps the precision.
  const squares = [1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz, 1 + xx + yy + zz]
  const candidates = [
    [squares[0], yx + xy, xz + zx, zy - yz],
    [yx + xy, squares[1], zy + yz, xz - zx],
    [xz + zx, zy + yz, squares[2], yx - xy],
    [zy - yz, xz - zx, yx - xy, squares[3]],
  ]
  const largest = squares.indexOf(Math.max(...squares))
  const divisor = 2 * Math.sqrt(squares[largest])
  return candidates[Math.max(0, largest)].map((value) => value / divisor)
}

import type { Accessor, Document, Mesh, Node, Primitive, Skin } from '@gltf-transform/core'
import type { SkinJoint } from 'furrow/author'
import type { PartInfluences } from 'furrow/internal'
import { Matrix4, Quaternion } from 'three'
import { sourceOf } from '../gltf/document.ts'
import { humanBonesOf } from '../json/human-bones.ts'
import { nodeOf } from './mesh-nodes.ts'

/** Maximum number of rotations per joint that are read from animations. Longer animations are sampled. */
const MAX_ROTATIONS = 256

/**
 * Reads the joints that move a mesh, with the rotations that animations give them. Returns undefined if no skeleton moves the mesh.
 *
 * @param placement matrix from the mesh to the space of the joints' bind matrices; default: identity.
 */
export type JointReader = (mesh: Mesh, placement: readonly number[] | undefined) => SkinJoint[] | undefined

/** Creates the reader for the meshes of a file. Animations are read once, for the first mesh with a skeleton. */
export function jointReader(document: Document): JointReader {
  let motion: Motion | undefined
  return (mesh, placement) => {
    const skin = nodeOf(mesh)?.getSkin()
    if (!skin) return undefined
    motion ??= motionOf(document)
    return readJoints(skin, placement, motion)
  }
}

/** Names and motion of a file's nodes. */
interface Motion {
  indexOf: ReadonlyMap<Node, number>
  /** Names of humanoid bones by index of the node. */
  bones: ReadonlyMap<number, string>
  rotations: ReadonlyMap<Node, number[][]>
}

function motionOf(document: Document): Motion {
  const nodes = document.getRoot().listNodes()
  return {
    indexOf: new Map(nodes.map((node, i) => [node, i])),
    bones: humanBonesOf(sourceOf(document)),
    rotations: animatedRotations(document),
  }
}

function readJoints(
  skin: Skin,
  placement: readonly number[] | undefined,
  { indexOf, bones, rotations }: Motion,
): SkinJoint[] {
  const nodes = skin.listJoints()
  const binds = bindMatrices(skin, placement)
  return nodes.map((node, i) => {
    const parent = nearestJoint(node, nodes)
    const rest = restRotation(node, binds[i], parent < 0 ? undefined : binds[parent], nodes[parent])
    const humanBone = bones.get(indexOf.get(node) ?? -1)
    return {
      name: node.getName() || String(indexOf.get(node)),
      parent,
      bind: binds[i].toArray(),
      ...(humanBone !== undefined && { humanBone }),
      rotations: fromRest(rotations.get(node) ?? [], rest),
    }
  })
}

/** Returns the influences of a primitive, from all its sets of four joints. */
export function influencesOf(primitive: Primitive): PartInfluences | undefined {
  const sets: number[] = []
  while (primitive.getAttribute(`JOINTS_${sets.length}`) && primitive.getAttribute(`WEIGHTS_${sets.length}`))
    sets.push(sets.length)
  if (sets.length === 0) return undefined
  const count = 4 * sets.length
  return {
    count,
    read(vertices, joints, weights) {
      const [joint, weight]: number[][] = [[], []]
      for (const set of sets) {
        const [ofJoints, ofWeights] = [
          primitive.getAttribute(`JOINTS_${set}`)!,
          primitive.getAttribute(`WEIGHTS_${set}`)!,
        ]
        for (let i = 0; i < vertices.length; i++) {
          ofJoints.getElement(vertices[i], joint)
          ofWeights.getElement(vertices[i], weight)
          for (let k = 0; k < 4; k++) {
            joints[count * i + 4 * set + k] = joint[k]
            weights[count * i + 4 * set + k] = weight[k]
          }
        }
      }
    },
  }
}

function bindMatrices(skin: Skin, placement: readonly number[] | undefined): Matrix4[] {
  const inverse = skin.getInverseBindMatrices()
  const toWorld = placement ? new Matrix4().fromArray(placement) : new Matrix4()
  return skin.listJoints().map((_, i) => {
    const bind = new Matrix4()
    if (inverse && i < inverse.getCount()) bind.fromArray(inverse.getElement(i, [])).invert()
    return bind.premultiply(toWorld)
  })
}

/** Returns the index of the nearest ancestor of a node that is a joint; -1 if there is none. */
function nearestJoint(node: Node, joints: readonly Node[]): number {
  for (let above = node.getParentNode(); above; above = above.getParentNode()) {
    const index = joints.indexOf(above)
    if (index >= 0) return index
  }
  return -1
}

/** Returns the rotation of a joint relative to its parent in the bind pose. */
function restRotation(
  node: Node,
  bind: Matrix4,
  parent: Matrix4 | undefined,
  above: Node | undefined,
): Quaternion {
  if (!parent || node.getParentNode() !== above) return new Quaternion().fromArray(node.getRotation())
  return rotationOf(parent).invert().multiply(rotationOf(bind))
}

function rotationOf(matrix: Matrix4): Quaternion {
  return new Quaternion().setFromRotationMatrix(new Matrix4().extractRotation(matrix))
}

/** Returns the rotations that animations give each node. */
function animatedRotations(document: Document): Map<Node, number[][]> {
  const found = new Map<Node, number[][]>()
  for (const animation of document.getRoot().listAnimations()) {
    for (const channel of animation.listChannels()) {
      const node = channel.getTargetNode()
      const sampler = channel.getSampler()
      const output = sampler?.getOutput()
      if (node && sampler && output && channel.getTargetPath() === 'rotation')
        addRotations(found, node, output, sampler.getInterpolation())
    }
  }
  for (const { node, output, interpolation } of pointedRotations(document))
    addRotations(found, node, output, interpolation)
  return found
}

function addRotations(
  found: Map<Node, number[][]>,
  node: Node,
  output: Accessor,
  interpolation: string,
): void {
  // A cubic spline stores two tangents with each rotation.
  const [step, first] = interpolation === 'CUBICSPLINE' ? [3, 1] : [1, 0]
  const keys = Math.floor(output.getCount() / step)
  const every = Math.max(1, Math.ceil(keys / MAX_ROTATIONS))
  const rotations = found.get(node) ?? []
  for (let key = 0; key < keys; key += every) rotations.push(output.getElement(step * key + first, []))
  found.set(node, rotations)
}

/** Parts of an animation that `KHR_animation_pointer` uses. The JSON of files is not checked in detail. */
interface PointedAnimation {
  channels?: { sampler?: number; target?: { extensions?: Record<string, { pointer?: unknown }> } }[]
  samplers?: { output?: number; interpolation?: string }[]
}

/** Lists the channels of animations that name the rotation of a node by a pointer. glTF-Transform does not read them. */
function pointedRotations(document: Document): { node: Node; output: Accessor; interpolation: string }[] {
  const [nodes, accessors] = [document.getRoot().listNodes(), document.getRoot().listAccessors()]
  const { animations = [] } = sourceOf(document) as { animations?: PointedAnimation[] }
  return animations.flatMap(({ channels = [], samplers = [] }) =>
    channels.flatMap(({ sampler = -1, target }) => {
      const pointer = target?.extensions?.KHR_animation_pointer?.pointer
      const match = /^\/nodes\/(\d+)\/rotation$/.exec(String(pointer))
      const node = nodes[Number(match?.[1] ?? -1)]
      const { output = -1, interpolation = 'LINEAR' } = samplers[sampler] ?? {}
      return node && accessors[output] ? [{ node, output: accessors[output], interpolation }] : []
    }),
  )
}

/** Returns rotations relative to the rest pose, packed. */
function fromRest(rotations: readonly number[][], rest: Quaternion): Float32Array {
  const inverse = rest.clone().invert()
  return Float32Array.from(
    rotations.flatMap((rotation) => inverse.clone().multiply(new Quaternion().fromArray(rotation)).toArray()),
  )
}

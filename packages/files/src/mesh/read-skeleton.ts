import type { Document, Mesh, Primitive, Skin } from '@gltf-transform/core'
import type { SkinJoint } from 'furrow/author'
import { keyRotations, type PartInfluences, rotationChannels, skinJoints } from 'furrow/internal'
import { Matrix4 } from 'three'
import { sourceOf } from '../gltf/document.ts'
import { nodeOf } from './mesh-nodes.ts'

/**
 * Reads the joints that move a mesh, with the rotations that animations give them. Returns undefined if no skeleton moves the mesh.
 *
 * @param placement matrix from the mesh to the space of the joints' bind matrices; default: identity.
 */
export type JointReader = (mesh: Mesh, placement: readonly number[] | undefined) => SkinJoint[] | undefined

/** Creates the reader for the meshes of a file. Animations are read once, for the first mesh with a skeleton. */
export function jointReader(document: Document): JointReader {
  let rotations: ReturnType<typeof animatedRotations> | undefined
  return (mesh, placement) => {
    const skin = nodeOf(mesh)?.getSkin()
    if (!skin) return undefined
    rotations ??= animatedRotations(document)
    const index = document.getRoot().listSkins().indexOf(skin)
    return skinJoints(sourceOf(document), index, bindMatrices(skin, placement), rotations)
  }
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

function bindMatrices(skin: Skin, placement: readonly number[] | undefined): number[][] {
  const inverse = skin.getInverseBindMatrices()
  const toWorld = placement ? new Matrix4().fromArray(placement) : new Matrix4()
  return skin.listJoints().map((_, i) => {
    const bind = new Matrix4()
    if (inverse && i < inverse.getCount()) bind.fromArray(inverse.getElement(i, [])).invert()
    return bind.premultiply(toWorld).toArray()
  })
}

/** Returns the rotations that animations give nodes, by index of the node. */
function animatedRotations(document: Document): Map<number, number[][]> {
  const accessors = document.getRoot().listAccessors()
  const found = new Map<number, number[][]>()
  for (const { node, output, interpolation } of rotationChannels(sourceOf(document))) {
    const accessor = accessors[output]
    if (!accessor) continue
    const rotations = keyRotations(interpolation, accessor.getCount(), (i) => accessor.getElement(i, []))
    found.set(node, [...(found.get(node) ?? []), ...rotations])
  }
  return found
}

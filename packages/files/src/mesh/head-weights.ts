import type { Mesh, Node, Primitive } from '@gltf-transform/core'
import { nodeOf } from './mesh-nodes.ts'

/** Writes the skinning weight of the head joint into `out`, 0..1 per vertex. */
export type HeadReader = (primitive: Primitive, vertices: Uint32Array, out: Float32Array) => void

/**
 * Returns a function that reads skinning weights of the head joint and its descendants. A mesh without a skeleton has
 * weight 1 if its node is below the head joint.
 *
 * @returns undefined if the mesh does not follow a head joint.
 */
export function headReader(mesh: Mesh): HeadReader | undefined {
  const node = nodeOf(mesh)
  if (!node) return undefined
  const skin = node.getSkin()
  if (!skin) return isOfHead(node) ? (_, _vertices, out) => void out.fill(1) : undefined
  const isHead = skin.listJoints().map(isOfHead)
  if (!isHead.includes(true)) return undefined
  return (primitive, vertices, out) => {
    const [joints, weights] = [primitive.getAttribute('JOINTS_0'), primitive.getAttribute('WEIGHTS_0')]
    if (!joints || !weights) return
    const [joint, weight]: number[][] = [[], []]
    for (let i = 0; i < vertices.length; i++) {
      joints.getElement(vertices[i], joint)
      weights.getElement(vertices[i], weight)
      out[i] = joint.reduce((sum, index, k) => sum + (isHead[index] ? weight[k] : 0), 0)
    }
  }
}

/** Returns whether a node is the head joint or below it. Recognises the head joint by its name. */
function isOfHead(node: Node): boolean {
  for (let above: Node | null = node; above; above = above.getParentNode()) {
    // A node with a mesh is not a joint, even if its name is "head".
    if (!above.getMesh() && /head|頭/i.test(above.getName())) return true
  }
  return false
}

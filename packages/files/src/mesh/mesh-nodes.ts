import { type Mesh, type mat4, type Node, Primitive } from '@gltf-transform/core'
import { Matrix4 } from 'three'

/** Returns the name of a node's mesh. If the mesh has no name, returns the name of the node. */
export function nameOf(node: Node): string {
  return node.getMesh()!.getName() || node.getName()
}

/** Returns the first node that places a mesh. */
export function nodeOf(mesh: Mesh): Node | undefined {
  return mesh.listParents().find((parent) => parent.propertyType === 'Node') as Node | undefined
}

/** Returns the primitives of a mesh that have triangles and texture coordinates. */
export function trianglesOf(mesh: Mesh): Primitive[] {
  return mesh.listPrimitives().filter((primitive) => {
    const textured = primitive.getAttribute('POSITION') && primitive.getAttribute('TEXCOORD_0')
    return textured && primitive.getMode() === Primitive.Mode.TRIANGLES
  })
}

/**
 * Returns the matrix from mesh to world space in rest pose. In glTF, joints place a skinned mesh, and the transform of
 * its node is ignored. In rest pose all joints give the same matrix, so this function uses the first joint.
 */
export function placementOf(node: Node): mat4 {
  const skin = node.getSkin()
  const joint = skin?.listJoints()[0]
  if (!skin || !joint) return node.getWorldMatrix()
  const world = new Matrix4().fromArray(joint.getWorldMatrix())
  const inverseBind = skin.getInverseBindMatrices()
  if (inverseBind) world.multiply(new Matrix4().fromArray(inverseBind.getElement(0, [])))
  return world.toArray()
}

import { type Mesh, type mat4, type Node, Primitive } from '@gltf-transform/core'
import { Matrix4 } from 'three'

/** Returns the name of a node's mesh, or of the node if the mesh has none. */
export function nameOf(node: Node): string {
  return node.getMesh()!.getName() || node.getName()
}

/** Returns the first node of a mesh. */
export function nodeOf(mesh: Mesh): Node | undefined {
  return mesh.listParents().find((parent) => parent.propertyType === 'Node') as Node | undefined
}

/** Returns the primitives of a mesh with triangles and texture coordinates. */
export function trianglesOf(mesh: Mesh): Primitive[] {
  return mesh.listPrimitives().filter((primitive) => {
    const textured = primitive.getAttribute('POSITION') && primitive.getAttribute('TEXCOORD_0')
    return textured && primitive.getMode() === Primitive.Mode.TRIANGLES
  })
}

/**
 * Returns the matrix from mesh to world space in the rest pose. glTF places a skinned mesh by its joints and ignores its node. In the
 * rest pose all joints give the same matrix.
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

import { type Document, type Mesh, type mat4, type Node, Primitive } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import { Matrix4 } from 'three'
import { didYouMean } from '../nearest.ts'

/** The mesh or material that commands choose when none is named and several exist. */
export const DEFAULT_NAME = 'skin'

/**
 * Finds the node of one mesh with texture coordinates: the one named `meshName`, by default the one named `skin` or
 * the only one.
 *
 * @param fallback chooses among several when none is named.
 * @throws FurrowError when there is none, or several and none is named.
 */
export function pickMesh(
  document: Document,
  path: string,
  meshName: string | undefined,
  who: string,
  fallback: () => Mesh | undefined = () => undefined,
): Node {
  const nodes = document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh() !== null)
  const usable = nodes.filter((node) => trianglesOf(node.getMesh()!).length > 0)
  const names = [...new Set(usable.map(nameOf))]
  const wanted = meshName ?? (names.includes(DEFAULT_NAME) ? DEFAULT_NAME : undefined)
  const matches = wanted === undefined ? usable : usable.filter((node) => nameOf(node) === wanted)
  const isOpen = wanted === undefined && names.length > 1
  const mesh = isOpen ? fallback() : undefined
  const node = isOpen ? usable.find((item) => item.getMesh() === mesh) : matches.at(0)
  if (node === undefined) {
    throw new FurrowError({
      code: 'unknown-name',
      who,
      what: wanted === undefined ? `several meshes in ${path}` : `no such mesh in ${path}`,
      value: wanted,
      limit: names.length === 0 ? 'none of its meshes has texture coordinates' : names.join(', '),
      remedy: didYouMean(wanted, names, 'name one with --mesh'),
    })
  }
  return node
}

/** The name of a node's mesh, or of the node where the mesh has none. */
export function nameOf(node: Node): string {
  return node.getMesh()!.getName() || node.getName()
}

/** The primitives of a mesh that are triangles with texture coordinates. */
export function trianglesOf(mesh: Mesh): Primitive[] {
  return mesh.listPrimitives().filter((primitive) => {
    const textured = primitive.getAttribute('POSITION') && primitive.getAttribute('TEXCOORD_0')
    return textured && primitive.getMode() === Primitive.Mode.TRIANGLES
  })
}

/**
 * The matrix from mesh to world space in the rest pose. glTF places a skinned mesh by its joints and ignores its
 * node; in the rest pose all joints give the same matrix.
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

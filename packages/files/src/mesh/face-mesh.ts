import type { Document, Node } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import type { MetricMesh } from 'furrow/author'
import { didYouMean } from 'furrow/internal'
import { Matrix4, Vector3 } from 'three'
import type { ReadOptions } from '../disk/external-files.ts'
import { readDocument } from '../gltf/read-document.ts'
import { DEFAULT_NAME } from '../json/target-names.ts'
import { mostMovedSkin } from './find-skin.ts'
import { nameOf, placementOf, trianglesOf } from './mesh-nodes.ts'

/** A mesh with texture coordinates, on which wrinkle strokes are drawn. */
export interface FaceMesh {
  name: string
  /** Positions in metres in world space, in rest pose and without blendshapes. */
  mesh: MetricMesh
  /** Encoded normal map of the first material that has one. */
  normalMap?: Uint8Array
  /** Whether the mesh has tangents. Otherwise three.js derives tangents on the GPU. */
  hasTangents: boolean
}

/**
 * Reads one mesh of a file.
 *
 * @param options.mesh name of the mesh. Default: chosen by `pickMesh`.
 * @throws FurrowError if the file cannot be read, or has no such mesh.
 */
export async function readFaceMesh(
  path: string,
  who: string,
  options: ReadOptions & { mesh?: string | undefined } = {},
): Promise<FaceMesh> {
  const document = await readDocument(path, who, options)
  const node = pickMesh(document, path, who, options.mesh)
  return { name: nameOf(node), ...readMesh(node) }
}

/**
 * Finds the node of a mesh with texture coordinates. Without `meshName`, chooses the mesh named `skin`. If there is
 * none, chooses the only mesh. If there are several, chooses the mesh with a surface that has more than half of the
 * motion of all surfaces, see `chooseSkin`.
 *
 * @throws FurrowError if no mesh matches, or if these rules choose none of several meshes.
 */
export function pickMesh(document: Document, path: string, who: string, meshName?: string): Node {
  const nodes = document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh() !== null)
  const usable = nodes.filter((node) => trianglesOf(node.getMesh()!).length > 0)
  const names = [...new Set(usable.map(nameOf))]
  const wanted = meshName ?? (names.includes(DEFAULT_NAME) ? DEFAULT_NAME : undefined)
  const matches = wanted === undefined ? usable : usable.filter((node) => nameOf(node) === wanted)
  const isAmbiguous = wanted === undefined && names.length > 1
  const node = isAmbiguous ? mostMovedNode(document, usable) : matches.at(0)
  if (node === undefined) {
    throw new FurrowError({
      code: 'unknown-name',
      who,
      problem: wanted === undefined ? `several meshes in ${path}` : `no such mesh in ${path}`,
      value: wanted,
      limit: names.length === 0 ? 'none of its meshes has texture coordinates' : names.join(', '),
      remedy: didYouMean(wanted, names, 'name one with --mesh'),
    })
  }
  return node
}

function mostMovedNode(document: Document, nodes: readonly Node[]): Node | undefined {
  const skin = mostMovedSkin(document)
  const mesh = skin && document.getRoot().listMeshes()[skin.mesh]
  return nodes.find((node) => node.getMesh() === mesh)
}

function readMesh(node: Node): Omit<FaceMesh, 'name'> {
  const placement = new Matrix4().fromArray(placementOf(node))
  const point = new Vector3()
  const positions: number[] = []
  const uvs: number[] = []
  const indices: number[] = []
  let normalMap: Uint8Array | undefined
  let hasTangents = true
  for (const primitive of trianglesOf(node.getMesh()!)) {
    const position = primitive.getAttribute('POSITION')!
    const uv = primitive.getAttribute('TEXCOORD_0')!
    const first = positions.length / 3
    for (let i = 0; i < position.getCount(); i++) {
      positions.push(...point.fromArray(position.getElement(i, [])).applyMatrix4(placement))
      uvs.push(...uv.getElement(i, []))
    }
    const index = primitive.getIndices()
    const count = index ? index.getCount() : position.getCount()
    for (let i = 0; i < count; i++) indices.push(first + (index ? index.getScalar(i) : i))
    hasTangents &&= primitive.getAttribute('TANGENT') !== null
    normalMap ??= primitive.getMaterial()?.getNormalTexture()?.getImage() ?? undefined
  }
  return { mesh: { positions, uvs, indices }, hasTangents, ...(normalMap && { normalMap }) }
}

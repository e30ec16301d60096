import { readFile } from 'node:fs/promises'
import {
  type Document,
  Logger,
  type Mesh,
  type mat4,
  type Node,
  NodeIO,
  Primitive,
} from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { FurrowError } from 'furrow'
import type { MetricMesh } from 'furrow/author'
import { firstLine } from './images.ts'

/** What authoring needs of a character: the shape of one mesh in its texture, and its skin's own normal map. */
export interface Face {
  /** Name of the mesh that was taken. */
  name: string
  /** Positions in metres as the node places them, neutral and unposed. */
  mesh: MetricMesh
  /** The encoded image of the material's normal map, where there is one. */
  normalMap?: Uint8Array
  /** Whether the mesh brings tangents of its own; without, three.js derives them on the GPU. */
  hasTangents: boolean
}

const WHO = 'furrow strokes'

/** The mesh that is taken when the user names none and the file has one of this name. */
const USUAL_NAME = 'skin'

/**
 * Reads one mesh of a .glb or .gltf file; without `meshName` the one named `skin`, or the only one with texture
 * coordinates. Throws FurrowError where the file cannot be read or has no such mesh.
 */
export async function readFace(path: string, meshName?: string): Promise<Face> {
  const node = pickMesh(await readDocument(path, WHO), path, meshName, WHO)
  return { name: nameOf(node), ...readMesh(node) }
}

/** The node of one mesh with texture coordinates: that of the name, or `skin`, or the only one. Throws FurrowError. */
export function pickMesh(document: Document, path: string, meshName: string | undefined, who: string): Node {
  const nodes = document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh() !== null)
  const usable = nodes.filter((node) => trianglesOf(node.getMesh()!).length > 0)
  const names = [...new Set(usable.map(nameOf))]
  const wanted = meshName ?? (names.includes(USUAL_NAME) ? USUAL_NAME : undefined)
  const matches = wanted === undefined ? usable : usable.filter((node) => nameOf(node) === wanted)
  const node = matches[0]
  if (node === undefined || (wanted === undefined && names.length > 1)) {
    throw new FurrowError({
      who,
      what: wanted === undefined ? `several meshes in ${path}` : `no such mesh in ${path}`,
      value: wanted,
      limit: names.length === 0 ? 'none of its meshes has texture coordinates' : names.join(', '),
      remedy: 'name one with --mesh',
    })
  }
  return node
}

/** Reads a .glb or .gltf file, compressed or not. Throws FurrowError where that cannot be done. */
export async function readDocument(path: string, who: string): Promise<Document> {
  try {
    const bytes = await readFile(path)
    // Of extensions that are none of its business it would warn.
    const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.ERROR)).registerExtensions(ALL_EXTENSIONS)
    io.registerDependencies(await decodersFor(bytes))
    return await io.read(path)
  } catch (error) {
    throw new FurrowError({
      who,
      what: `cannot read the face ${path} (${firstLine(error)})`,
      limit: 'glTF 2.0',
      remedy: 'check the path and the file',
    })
  }
}

/** Decoders take their time to start, and few files need them. */
async function decodersFor(bytes: Buffer): Promise<Record<string, unknown>> {
  const decoders: Record<string, unknown> = {}
  if (bytes.includes('KHR_draco_mesh_compression')) {
    const { default: draco3d } = await import('draco3d')
    decoders['draco3d.decoder'] = await draco3d.createDecoderModule()
  }
  if (bytes.includes('_meshopt_compression')) {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder')
    await MeshoptDecoder.ready
    decoders['meshopt.decoder'] = MeshoptDecoder
  }
  return decoders
}

/** Files name the mesh, its node, or both. */
export function nameOf(node: Node): string {
  return node.getMesh()!.getName() || node.getName()
}

export function trianglesOf(mesh: Mesh): Primitive[] {
  return mesh.listPrimitives().filter((primitive) => {
    const textured = primitive.getAttribute('POSITION') && primitive.getAttribute('TEXCOORD_0')
    return textured && primitive.getMode() === Primitive.Mode.TRIANGLES
  })
}

function readMesh(node: Node): Omit<Face, 'name'> {
  const placement = placementOf(node)
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
      const [x, y, z] = position.getElement(i, [0, 0, 0]) as [number, number, number]
      for (let k = 0; k < 3; k++) {
        positions.push(placement[k] * x + placement[4 + k] * y + placement[8 + k] * z + placement[12 + k])
      }
      uvs.push(...uv.getElement(i, [0, 0]))
    }
    const index = primitive.getIndices()
    const count = index ? index.getCount() : position.getCount()
    for (let i = 0; i < count; i++) indices.push(first + (index ? index.getScalar(i) : i))
    hasTangents &&= primitive.getAttribute('TANGENT') !== null
    normalMap ??= primitive.getMaterial()?.getNormalTexture()?.getImage() ?? undefined
  }
  return { mesh: { positions, uvs, indices }, hasTangents, ...(normalMap && { normalMap }) }
}

/** glTF places a skinned mesh by its joints, not by its node; in the rest pose all joints agree. */
export function placementOf(node: Node): mat4 {
  const skin = node.getSkin()
  const joint = skin?.listJoints()[0]
  if (!skin || !joint) return node.getWorldMatrix()
  const world = joint.getWorldMatrix()
  const inverseBind = skin.getInverseBindMatrices()
  if (!inverseBind) return world
  const bind = inverseBind.getElement(0, new Array(16).fill(0))
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, 4 * Math.floor(i / 4)]
    return [0, 1, 2, 3].reduce((sum, k) => sum + world[4 * k + row] * bind[column + k]!, 0)
  }) as mat4
}

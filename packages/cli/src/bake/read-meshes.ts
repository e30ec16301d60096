import { type Node, Primitive } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import type { BakeMesh } from 'furrow/author'
import { generateTangents } from 'mikktspace'
import { BufferAttribute, Matrix4, Vector3 } from 'three'
import type { ReadOptions } from '../gltf/external-files.ts'
import { pickMesh } from '../gltf/face-mesh.ts'
import { nameOf, placementOf, trianglesOf } from '../gltf/mesh-nodes.ts'
import { readDocument } from '../gltf/read-document.ts'

const WHO = 'furrow bake'

/** A detailed surface in metres, transformed as in its file. */
export interface Surface {
  /** x, y and z of each vertex. */
  positions: Float32Array
  /** Normal of each vertex; absent if any of the meshes has none, and the surface is shaded flat. */
  normals?: Float32Array
  /** Three vertices per triangle. */
  indices: Uint32Array
}

/** Tangents of a mesh without tangents of its own: see TangentFrame. */
export type Tangents = 'mikktspace' | 'derivative'

/** Reads all triangles of a file as one surface, neutral and in rest pose. Throws FurrowError if there are none. */
export async function readSurface(path: string, options: ReadOptions = {}): Promise<Surface> {
  const document = await readDocument(path, WHO, options)
  const parts = document
    .getRoot()
    .listNodes()
    .flatMap((node) => (node.getMesh()?.listPrimitives() ?? []).map((primitive) => ({ node, primitive })))
    .filter(({ primitive }) => {
      return primitive.getMode() === Primitive.Mode.TRIANGLES && primitive.getAttribute('POSITION')
    })
  const isSmooth = parts.every(({ primitive }) => primitive.getAttribute('NORMAL'))
  const positions: Float32Array[] = []
  const normals: Float32Array[] = []
  const indices: Uint32Array[] = []
  let first = 0
  for (const { node, primitive } of parts) {
    const matrix = matrixOf(node)
    const part = {
      positions: readAttribute(primitive, 'POSITION', 3),
      normals: isSmooth ? readAttribute(primitive, 'NORMAL', 3) : undefined,
    }
    transform(part, matrix)
    positions.push(part.positions)
    if (part.normals) normals.push(part.normals)
    indices.push(cornersOf(primitive, isMirroring(matrix)).map((vertex) => first + vertex))
    first += part.positions.length / 3
  }
  const surface: Surface = {
    positions: join(Float32Array, positions),
    indices: join(Uint32Array, indices),
    ...(isSmooth && { normals: join(Float32Array, normals) }),
  }
  if (surface.indices.length === 0) throw noTriangles(path)
  checkFinite(surface.positions, path)
  return surface
}

/**
 * Reads the mesh that the maps are for, unindexed, with its own tangents, MikkTSpace's, or none.
 *
 * @throws FurrowError if it cannot be read, or has no texture coordinates or no normals.
 */
export async function readLow(
  path: string,
  meshName: string | undefined,
  tangents: Tangents,
  options: ReadOptions = {},
): Promise<{ name: string; mesh: BakeMesh; tangents: 'of the mesh' | Tangents }> {
  const node = pickMesh(await readDocument(path, WHO, options), path, WHO, meshName)
  const parts = trianglesOf(node.getMesh()!)
  if (!parts.every((primitive) => primitive.getAttribute('NORMAL'))) {
    throw fault(
      `${nameOf(node)} in ${path} has no normals`,
      'smooth normals',
      'export the low mesh with normals',
    )
  }
  const hasTangents = parts.every((primitive) => primitive.getAttribute('TANGENT'))
  const source = hasTangents ? 'of the mesh' : tangents
  const meshes = parts.map((primitive) => readUnindexed(primitive, source, path))
  if (meshes.every(({ positions }) => positions.length === 0)) throw noTriangles(path)
  for (const mesh of meshes) transform(mesh, matrixOf(node))
  const joined = (name: 'positions' | 'normals' | 'uvs') =>
    join(
      Float32Array,
      meshes.map((part) => part[name]),
    )
  const mesh: BakeMesh = { positions: joined('positions'), normals: joined('normals'), uvs: joined('uvs') }
  const partTangents = meshes.flatMap((part) => part.tangents ?? [])
  if (partTangents.length > 0) mesh.tangents = join(Float32Array, partTangents)
  checkFinite(mesh.positions, path)
  return { name: nameOf(node), mesh, tangents: source }
}

function readUnindexed(primitive: Primitive, tangents: 'of the mesh' | Tangents, path: string): BakeMesh {
  const corners = cornersOf(primitive, false)
  const perCorner = (name: string, size: number) => {
    const values = readAttribute(primitive, name, size)
    const out = new Float32Array(size * corners.length)
    for (let i = 0; i < corners.length; i++) {
      for (let k = 0; k < size; k++) out[size * i + k] = values[size * corners[i] + k]
    }
    return out
  }
  const mesh: BakeMesh = {
    positions: perCorner('POSITION', 3),
    normals: perCorner('NORMAL', 3),
    uvs: perCorner('TEXCOORD_0', 2),
  }
  for (const values of [mesh.positions, mesh.normals, mesh.uvs]) checkFinite(values, path)
  if (tangents === 'of the mesh') mesh.tangents = perCorner('TANGENT', 4)
  if (tangents === 'mikktspace') mesh.tangents = mikktspace(mesh, path)
  return mesh
}

/** MikkTSpace's v points up, glTF's down, which negates w. */
function mikktspace({ positions, normals, uvs }: BakeMesh, path: string): Float32Array {
  let tangents: Float32Array
  try {
    tangents = generateTangents(positions, normals, uvs)
  } catch {
    // Its WebAssembly traps where no triangle is left that has an area.
    throw fault(`no tangents can be computed for ${path}`, 'triangles with an area', 'export the mesh again')
  }
  for (let i = 3; i < tangents.length; i += 4) tangents[i] *= -1
  return tangents
}

function readAttribute(primitive: Primitive, name: string, size: number): Float32Array {
  const accessor = primitive.getAttribute(name)!
  const out = new Float32Array(size * accessor.getCount())
  const element: number[] = []
  for (let i = 0; i < accessor.getCount(); i++) {
    accessor.getElement(i, element)
    for (let k = 0; k < size; k++) out[size * i + k] = element[k]
  }
  return out
}

/** Vertices of the triangles; `isMirrored` swaps two of each, for a node whose matrix mirrors. */
function cornersOf(primitive: Primitive, isMirrored: boolean): Uint32Array {
  const index = primitive.getIndices()
  const count = index ? index.getCount() : primitive.getAttribute('POSITION')!.getCount()
  const corners = new Uint32Array(count - (count % 3))
  for (let i = 0; i < corners.length; i++) corners[i] = index ? index.getScalar(i) : i
  for (let i = 0; isMirrored && i < corners.length; i += 3) {
    const second = corners[i + 1]
    corners[i + 1] = corners[i + 2]
    corners[i + 2] = second
  }
  return corners
}

function matrixOf(node: Node): Matrix4 {
  return new Matrix4().fromArray(placementOf(node))
}

/** Transforms vertices in place; normals and tangents are normalised. */
function transform(
  { positions, normals, tangents }: Partial<BakeMesh> & Pick<BakeMesh, 'positions'>,
  matrix: Matrix4,
): void {
  new BufferAttribute(positions, 3).applyMatrix4(matrix)
  if (normals) transformDirections(new BufferAttribute(normals, 3), normalMatrixOf(matrix))
  if (tangents) transformDirections(new BufferAttribute(tangents, 4), matrix.clone().setPosition(0, 0, 0))
}

/** The cofactor matrix: the inverse transpose times the determinant's absolute value, so that a zero scale does no harm. */
function normalMatrixOf(matrix: Matrix4): Matrix4 {
  const sign = isMirroring(matrix) ? -1 : 1
  const [x, y, z] = [0, 1, 2].map((k) => new Vector3().setFromMatrixColumn(matrix, k))
  const cofactors = (a: Vector3, b: Vector3) => a.clone().cross(b).multiplyScalar(sign)
  return new Matrix4().makeBasis(cofactors(y, z), cofactors(z, x), cofactors(x, y))
}

function transformDirections(directions: BufferAttribute, matrix: Matrix4): void {
  directions.applyMatrix4(matrix)
  const direction = new Vector3()
  for (let i = 0; i < directions.count; i++) {
    const { x, y, z } = direction.fromBufferAttribute(directions, i).normalize()
    directions.setXYZ(i, x, y, z)
  }
}

function isMirroring(matrix: Matrix4): boolean {
  return matrix.determinant() < 0
}

function join<T extends Float32Array | Uint32Array>(type: new (length: number) => T, parts: readonly T[]): T {
  const out = new type(parts.reduce((sum, part) => sum + part.length, 0))
  let offset = 0
  for (const part of parts) {
    out.set(part, offset)
    offset += part.length
  }
  return out
}

function checkFinite(values: Float32Array, path: string): void {
  const bad = values.findIndex((value) => !Number.isFinite(value))
  if (bad >= 0)
    throw fault(`a vertex of ${path} is at ${values[bad]}`, 'finite numbers', 'export the mesh again')
}

function noTriangles(path: string): FurrowError {
  return fault(`no triangles in ${path}`, 'a mesh of triangles', 'export it as a mesh')
}

function fault(what: string, limit: string, remedy: string): FurrowError {
  return new FurrowError({ who: WHO, what, limit, remedy })
}

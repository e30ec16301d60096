import { type mat4, type Node, Primitive } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import type { BakeMesh } from 'furrow/author'
import { generateTangents } from 'mikktspace'
import { nameOf, pickMesh, placementOf, readDocument, trianglesOf } from '../face.ts'

const WHO = 'furrow bake'

/** A detailed surface; all of its vertices in metres, placed as in the file. */
export interface Surface {
  positions: Float32Array
  /** Per vertex; absent where one of the meshes has none, and the surface is shaded flat. */
  normals?: Float32Array
  /** Three per triangle. */
  indices: Uint32Array
}

/** Where tangents come from when the mesh brings none: see TangentFrame. */
export type Tangents = 'mikktspace' | 'derivative'

/** Reads all triangles of a file as one surface, neutral and unposed. Throws FurrowError where there is none. */
export async function readSurface(path: string): Promise<Surface> {
  const document = await readDocument(path, WHO)
  const parts = document
    .getRoot()
    .listNodes()
    .flatMap((node) => (node.getMesh()?.listPrimitives() ?? []).map((primitive) => ({ node, primitive })))
    .filter(({ primitive }) => {
      return primitive.getMode() === Primitive.Mode.TRIANGLES && primitive.getAttribute('POSITION')
    })
  const vertices = parts.reduce(
    (sum, { primitive }) => sum + primitive.getAttribute('POSITION')!.getCount(),
    0,
  )
  const positions = new Float32Array(3 * vertices)
  const normals = new Float32Array(3 * vertices)
  const smooth = parts.every(({ primitive }) => primitive.getAttribute('NORMAL'))
  const indices: Uint32Array[] = []
  let first = 0
  for (const { node, primitive } of parts) {
    const placement = placementOf(node)
    positions.set(placed(placement, elements(primitive, 'POSITION', 3), 1), 3 * first)
    if (smooth) normals.set(placedNormals(placement, elements(primitive, 'NORMAL', 3)), 3 * first)
    const corners = cornersOf(primitive, isMirrored(placement))
    indices.push(corners.map((i) => first + i))
    first += primitive.getAttribute('POSITION')!.getCount()
  }
  const joined = new Uint32Array(indices.reduce((sum, part) => sum + part.length, 0))
  let at = 0
  for (const part of indices) {
    joined.set(part, at)
    at += part.length
  }
  if (joined.length === 0)
    throw fault(`no triangles in ${path}`, 'a mesh of triangles', 'export the sculpt as a mesh')
  checkFinite(positions, path)
  return { positions, indices: joined, ...(smooth && { normals }) }
}

/**
 * Reads the mesh that the maps are for, corner by corner, with its own tangents, MikkTSpace's, or none.
 * Throws FurrowError where it cannot be read, or has no texture coordinates or no normals.
 */
export async function readLow(
  path: string,
  meshName: string | undefined,
  tangents: Tangents,
): Promise<{ name: string; mesh: BakeMesh; tangents: 'of the mesh' | Tangents }> {
  const node = pickMesh(await readDocument(path, WHO), path, meshName, WHO)
  const parts = trianglesOf(node.getMesh()!)
  if (!parts.every((primitive) => primitive.getAttribute('NORMAL'))) {
    throw fault(
      `${nameOf(node)} in ${path} has no normals`,
      'smooth normals',
      'export the low mesh with normals',
    )
  }
  const own = parts.every((primitive) => primitive.getAttribute('TANGENT'))
  const meshes = parts.map((primitive) => readCorners(node, primitive, own, tangents))
  const mesh: BakeMesh = {
    positions: join(meshes.map((part) => part.positions)),
    normals: join(meshes.map((part) => part.normals)),
    uvs: join(meshes.map((part) => part.uvs)),
  }
  if (own || tangents === 'mikktspace') mesh.tangents = join(meshes.map((part) => part.tangents!))
  checkFinite(mesh.positions, path)
  checkFinite(mesh.normals, path)
  checkFinite(mesh.uvs, path)
  return { name: nameOf(node), mesh, tangents: own ? 'of the mesh' : tangents }
}

function readCorners(node: Node, primitive: Primitive, own: boolean, wanted: Tangents): BakeMesh {
  const placement = placementOf(node)
  const corners = cornersOf(primitive, false)
  const perCorner = (name: string, size: number) => {
    const values = elements(primitive, name, size)
    const out = new Float32Array(size * corners.length)
    for (let i = 0; i < corners.length; i++) {
      for (let k = 0; k < size; k++) out[size * i + k] = values[size * corners[i] + k]
    }
    return out
  }
  const [positions, normals, uvs] = [
    perCorner('POSITION', 3),
    perCorner('NORMAL', 3),
    perCorner('TEXCOORD_0', 2),
  ]
  const mesh: BakeMesh = {
    positions: placed(placement, positions, 1),
    normals: placedNormals(placement, normals),
    uvs,
  }
  if (own) mesh.tangents = placedTangents(placement, perCorner('TANGENT', 4))
  else if (wanted === 'mikktspace')
    mesh.tangents = placedTangents(placement, mikktspace(positions, normals, uvs))
  return mesh
}

/** MikkTSpace counts v upwards, glTF downwards: its sign is the other one. */
function mikktspace(positions: Float32Array, normals: Float32Array, uvs: Float32Array): Float32Array {
  const tangents = generateTangents(positions, normals, uvs)
  for (let i = 3; i < tangents.length; i += 4) tangents[i] *= -1
  return tangents
}

function elements(primitive: Primitive, name: string, size: number): Float32Array {
  const accessor = primitive.getAttribute(name)!
  const out = new Float32Array(size * accessor.getCount())
  const element: number[] = []
  for (let i = 0; i < accessor.getCount(); i++) {
    accessor.getElement(i, element)
    for (let k = 0; k < size; k++) out[size * i + k] = element[k]
  }
  return out
}

/** Vertices of the triangles; `turned` swaps two of each, for a mesh that its node mirrors. */
function cornersOf(primitive: Primitive, turned: boolean): Uint32Array {
  const index = primitive.getIndices()
  const count = index ? index.getCount() : primitive.getAttribute('POSITION')!.getCount()
  const corners = new Uint32Array(count - (count % 3))
  for (let i = 0; i < corners.length; i++) corners[i] = index ? index.getScalar(i) : i
  for (let i = 0; turned && i < corners.length; i += 3) {
    const second = corners[i + 1]
    corners[i + 1] = corners[i + 2]
    corners[i + 2] = second
  }
  return corners
}

function placed(m: mat4, vectors: Float32Array, w: 0 | 1): Float32Array {
  const out = new Float32Array(vectors.length)
  for (let i = 0; i < vectors.length; i += 3) {
    const [x, y, z] = [vectors[i], vectors[i + 1], vectors[i + 2]]
    for (let k = 0; k < 3; k++) out[i + k] = m[k] * x + m[4 + k] * y + m[8 + k] * z + w * m[12 + k]
  }
  return out
}

/** Normals turn with the cofactors of the matrix (its inverse transposed, times the determinant). */
function placedNormals(m: mat4, normals: Float32Array): Float32Array {
  const turned = isMirrored(m) ? -1 : 1
  const cofactor = (row: number, column: number) => {
    const [r1, r2, c1, c2] = [(row + 1) % 3, (row + 2) % 3, (column + 1) % 3, (column + 2) % 3]
    return turned * (m[4 * c1 + r1] * m[4 * c2 + r2] - m[4 * c1 + r2] * m[4 * c2 + r1])
  }
  const c = Array.from({ length: 16 }, (_, i) =>
    i % 4 < 3 && i < 12 ? cofactor(i % 4, Math.floor(i / 4)) : 0,
  )
  return unit(placed(c as mat4, normals, 0))
}

function placedTangents(m: mat4, tangents: Float32Array): Float32Array {
  const directions = Float32Array.from({ length: (tangents.length / 4) * 3 }, (_, i) => {
    return tangents[4 * Math.floor(i / 3) + (i % 3)]
  })
  const turned = unit(placed(m, directions, 0))
  return tangents.map((value, i) => (i % 4 === 3 ? value : turned[3 * Math.floor(i / 4) + (i % 4)]))
}

function unit(vectors: Float32Array): Float32Array {
  for (let i = 0; i < vectors.length; i += 3) {
    const length = Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]) || 1
    for (let k = 0; k < 3; k++) vectors[i + k] /= length
  }
  return vectors
}

function isMirrored(m: mat4): boolean {
  const [a, b, c] = [m.slice(0, 3), m.slice(4, 7), m.slice(8, 11)] as [number[], number[], number[]]
  return (
    a[0] * (b[1] * c[2] - b[2] * c[1]) -
      a[1] * (b[0] * c[2] - b[2] * c[0]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]) <
    0
  )
}

function join(parts: readonly Float32Array[]): Float32Array {
  const out = new Float32Array(parts.reduce((sum, part) => sum + part.length, 0))
  let at = 0
  for (const part of parts) {
    out.set(part, at)
    at += part.length
  }
  return out
}

function checkFinite(values: Float32Array, path: string): void {
  const bad = values.findIndex((value) => !Number.isFinite(value))
  if (bad >= 0)
    throw fault(`a vertex of ${path} is at ${values[bad]}`, 'finite numbers', 'export the mesh again')
}

function fault(what: string, limit: string, remedy: string): FurrowError {
  return new FurrowError({ who: WHO, what, limit, remedy })
}

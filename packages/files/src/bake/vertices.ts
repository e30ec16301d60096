import type { Node, Primitive } from '@gltf-transform/core'
import { FurrowError } from 'furrow'
import type { BakeMesh } from 'furrow/author'
import { BufferAttribute, Matrix4, Vector3 } from 'three'
import { placementOf } from '../mesh/mesh-nodes.ts'

export function readAttribute(primitive: Primitive, name: string, size: number): Float32Array {
  const accessor = primitive.getAttribute(name)!
  const out = new Float32Array(size * accessor.getCount())
  const element: number[] = []
  for (let i = 0; i < accessor.getCount(); i++) {
    accessor.getElement(i, element)
    for (let k = 0; k < size; k++) out[size * i + k] = element[k]
  }
  return out
}

/** Returns three vertex indices per triangle. `isMirrored` reverses the winding, for nodes with a mirroring matrix. */
export function cornersOf(primitive: Primitive, isMirrored: boolean): Uint32Array {
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

export function matrixOf(node: Node): Matrix4 {
  return new Matrix4().fromArray(placementOf(node))
}

/** Transforms positions, normals and tangents in place. Normalises normals and tangents. */
export function transform(
  { positions, normals, tangents }: Partial<BakeMesh> & Pick<BakeMesh, 'positions'>,
  matrix: Matrix4,
): void {
  new BufferAttribute(positions, 3).applyMatrix4(matrix)
  if (normals) transformDirections(new BufferAttribute(normals, 3), normalMatrixOf(matrix))
  if (tangents) transformDirections(new BufferAttribute(tangents, 4), matrix.clone().setPosition(0, 0, 0))
}

/**
 * Returns the cofactor matrix, which is the inverse transpose times `|determinant|`. It exists also if a scale is 0.
 */
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

export function isMirroring(matrix: Matrix4): boolean {
  return matrix.determinant() < 0
}

export function join<T extends Float32Array | Uint32Array>(
  type: new (length: number) => T,
  parts: readonly T[],
): T {
  const out = new type(parts.reduce((sum, part) => sum + part.length, 0))
  let offset = 0
  for (const part of parts) {
    out.set(part, offset)
    offset += part.length
  }
  return out
}

export function checkFinite(values: Float32Array, path: string, who: string): void {
  const bad = values.findIndex((value) => !Number.isFinite(value))
  if (bad >= 0)
    throw meshError(
      who,
      `a vertex of ${path} is at ${values[bad]}`,
      'finite numbers',
      'export the mesh again',
    )
}

export function noTriangles(path: string, who: string): FurrowError {
  return meshError(who, `no triangles in ${path}`, 'a mesh of triangles', 'export it as a mesh')
}

export function meshError(who: string, problem: string, limit: string, remedy: string): FurrowError {
  return new FurrowError({ who, problem, limit, remedy })
}

import { interpolate } from '../../math/barycentrics.ts'
import { triangleNormal } from '../../math/triangle.ts'
import { cross, dot, normalize } from '../../math/vector.ts'
import type { BakeMesh } from './mesh.ts'

/** Converts directions into the tangent space of one triangle. */
export interface TangentSpace {
  /** Selects a triangle by its first corner. */
  select(corner: number): void
  /**
   * Writes to `out` the tangent-space vector that a renderer turns into `direction` at the barycentric coordinates `a`, `b`, `c` of the
   * selected triangle. The vector is not normalised. Returns false and leaves `out` unchanged if the frame is degenerate.
   */
  encode(a: number, b: number, c: number, direction: ArrayLike<number>, out: Float64Array): boolean
}

/** A frame is degenerate if the absolute value of its determinant is at most this. */
const DEGENERATE = 1e-6

/**
 * Returns the tangent space in which renderers read a mesh's normal map. If the mesh has tangents, this is glTF's frame: bitangents are
 * `w * cross(normal, tangent)` at the vertices. Tangent, bitangent and normal are interpolated and then normalised, as in three.js and the
 * Khronos sample renderer. If the mesh has no tangents, this is three.js's derivative frame. Interpolated frames are not orthogonal, so
 * `encode` inverts their matrix by Cramer's rule.
 */
export function tangentSpaceOf(mesh: BakeMesh): TangentSpace {
  const readFrame = mesh.tangents ? vertexFrame(mesh, mesh.tangents) : derivativeFrame(mesh)
  const [t, b, n] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  const [bn, nt, tb] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  let first = 0
  return {
    select(corner) {
      first = corner
      readFrame.select(corner)
    },
    encode(wa, wb, wc, direction, out) {
      interpolateUnit(n, mesh.normals, 3, first, wa, wb, wc)
      readFrame.read(wa, wb, wc, n, t, b)
      cross(bn, b, n)
      const det = dot(t, bn)
      if (!(Math.abs(det) > DEGENERATE)) return false
      cross(nt, n, t)
      cross(tb, t, b)
      out[0] = dot(direction, bn) / det
      out[1] = dot(direction, nt) / det
      out[2] = dot(direction, tb) / det
      return true
    },
  }
}

/**
 * Interpolates unit vectors at the corners of a triangle and normalises the result.
 *
 * @param first first corner of the triangle.
 * @param a, b, c barycentric coordinates.
 */
export function interpolateUnit(
  out: Float64Array,
  vectors: ArrayLike<number>,
  stride: 3 | 4,
  first: number,
  a: number,
  b: number,
  c: number,
): void {
  interpolate(out, vectors, stride, first, first + 1, first + 2, a, b, c)
  const length = Math.sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2])
  for (let k = 0; k < 3; k++) out[k] /= length
}

/** Computes the tangent t and the bitangent b at a point of the selected triangle, given the normal n at this point. */
interface FrameReader {
  select(corner: number): void
  read(wa: number, wb: number, wc: number, n: Float64Array, t: Float64Array, b: Float64Array): void
}

function vertexFrame({ normals }: BakeMesh, tangents: Float32Array): FrameReader {
  const bitangents = bitangentsOf(normals, tangents)
  let first = 0
  return {
    select(corner) {
      first = corner
    },
    read(wa, wb, wc, _, t, b) {
      interpolateUnit(t, tangents, 4, first, wa, wb, wc)
      interpolateUnit(b, bitangents, 3, first, wa, wb, wc)
    },
  }
}

function bitangentsOf(normals: Float32Array, tangents: Float32Array): Float32Array {
  const out = new Float32Array(normals.length)
  const bitangent = new Float64Array(3)
  for (let i = 0; i < normals.length / 3; i++) {
    cross(bitangent, normals.subarray(3 * i, 3 * i + 3), tangents.subarray(4 * i, 4 * i + 3))
    for (let k = 0; k < 3; k++) bitangent[k] *= tangents[4 * i + 3]
    normalize(bitangent)
    out.set(bitangent, 3 * i)
  }
  return out
}

/**
 * Returns the frame of a mesh without tangents, as `getTangentFrame` in three.js's shaders computes it (Schueler, Normal Mapping Without
 * Precomputed Tangents, ShaderX 5, 2006). The shader uses derivatives along the screen axes; this function uses derivatives along two edges
 * of the triangle instead. The bitangent points towards smaller v, because `GLTFLoader` flips `normalScale.y` for meshes without tangents.
 */
function derivativeFrame(mesh: BakeMesh): FrameReader {
  const [u, v] = [new Float64Array(6), new Float64Array(6)]
  return {
    select(corner) {
      scaleEdges(mesh, corner, u, v)
    },
    read(_wa, _wb, _wc, n, t, b) {
      for (let k = 0; k < 3; k++) {
        const [k1, k2] = [(k + 1) % 3, (k + 2) % 3]
        t[k] = u[k1] * n[k2] - u[k2] * n[k1] + (n[k1] * u[3 + k2] - n[k2] * u[3 + k1])
        b[k] = -(v[k1] * n[k2] - v[k2] * n[k1] + (n[k1] * v[3 + k2] - n[k2] * v[3 + k1]))
      }
      const longer = Math.sqrt(Math.max(dot(t, t), dot(b, b)))
      for (let k = 0; k < 3; k++) {
        t[k] /= longer
        b[k] /= longer
      }
    },
  }
}

/** Computes the terms of the gradients of u and v: two edges of a triangle, each scaled by the change of u (or v) along the other edge. */
function scaleEdges(
  { positions, uvs, normals }: BakeMesh,
  corner: number,
  u: Float64Array,
  v: Float64Array,
): void {
  const position = (i: number, k: number) => positions[3 * (corner + i) + k] - positions[3 * corner + k]
  const uv = (i: number, k: number) => uvs[2 * (corner + i) + k] - uvs[2 * corner + k]
  const faceNormal = new Float64Array(3)
  triangleNormal(faceNormal, positions, corner, corner + 1, corner + 2)
  // Seen from the side of the normals, the turn from the first to the second edge must be counterclockwise, as it is for the screen axes.
  const side = dot(faceNormal, normals.subarray(3 * corner, 3 * corner + 3)) < 0 ? -1 : 1
  for (let k = 0; k < 3; k++) {
    const [edge1, edge2] = [position(1, k), position(2, k)]
    u[k] = side * edge2 * uv(1, 0)
    u[3 + k] = side * edge1 * uv(2, 0)
    v[k] = side * edge2 * uv(1, 1)
    v[3 + k] = side * edge1 * uv(2, 1)
  }
}

import type { BakeMesh } from './mesh.ts'

/** Turns a direction in space into tangent space, at a place of one triangle. */
export interface Frame {
  /** Chooses a triangle by its first corner. */
  triangle(corner: number): void
  /**
   * Writes into `out` what a normal map must hold for `n` to be shaded, not normalised; `a`, `b`, `c` are the
   * barycentric coordinates of the place. Returns false, and writes nothing, where the frame has no volume.
   */
  toTangent(a: number, b: number, c: number, n: ArrayLike<number>, out: Float64Array): boolean
}

/**
 * The frame in which renderers read the map of this mesh. With tangents it is glTF's: the bitangent is made at the
 * vertices as cross(normal, tangent) w, and all three are interpolated and normalised, as three.js and the Khronos sample
 * renderer do. Without, it is three.js's derivative frame. Neither is orthogonal between vertices, so it is inverted as it
 * is (Cramer's rule): the map decodes to the wanted direction exactly.
 */
export function frameOf(mesh: BakeMesh): Frame {
  const bitangents = mesh.tangents && bitangentsOf(mesh)
  const [t, b, n] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  const [gradientU, gradientV] = [new Float64Array(6), new Float64Array(6)]
  let first = 0
  return {
    triangle(corner) {
      first = corner
      if (!bitangents) edges(mesh, corner, gradientU, gradientV)
    },
    toTangent(wa, wb, wc, direction, out) {
      interpolate(mesh.normals, 3, first, wa, wb, wc, n)
      if (bitangents) {
        interpolate(mesh.tangents!, 4, first, wa, wb, wc, t)
        interpolate(bitangents, 3, first, wa, wb, wc, b)
      } else derivativeFrame(gradientU, gradientV, n, t, b)
      const [bnx, bny, bnz] = [
        b[1] * n[2] - b[2] * n[1],
        b[2] * n[0] - b[0] * n[2],
        b[0] * n[1] - b[1] * n[0],
      ]
      const det = t[0] * bnx + t[1] * bny + t[2] * bnz
      if (!(Math.abs(det) > 1e-6)) return false
      const [dx, dy, dz] = [direction[0], direction[1], direction[2]]
      const [ntx, nty, ntz] = [
        n[1] * t[2] - n[2] * t[1],
        n[2] * t[0] - n[0] * t[2],
        n[0] * t[1] - n[1] * t[0],
      ]
      const [tbx, tby, tbz] = [
        t[1] * b[2] - t[2] * b[1],
        t[2] * b[0] - t[0] * b[2],
        t[0] * b[1] - t[1] * b[0],
      ]
      out[0] = (dx * bnx + dy * bny + dz * bnz) / det
      out[1] = (dx * ntx + dy * nty + dz * ntz) / det
      out[2] = (dx * tbx + dy * tby + dz * tbz) / det
      return true
    },
  }
}

/** Mean of three corners' vectors, weighted and made a unit vector. */
export function interpolate(
  vectors: ArrayLike<number>,
  stride: 3 | 4,
  first: number,
  a: number,
  b: number,
  c: number,
  out: Float64Array,
): void {
  const i = first * stride
  for (let k = 0; k < 3; k++) {
    out[k] = a * vectors[i + k] + b * vectors[i + stride + k] + c * vectors[i + 2 * stride + k]
  }
  const length = Math.sqrt(out[0] ** 2 + out[1] ** 2 + out[2] ** 2)
  for (let k = 0; k < 3; k++) out[k] /= length
}

function bitangentsOf({ normals, tangents }: BakeMesh): Float32Array {
  const out = new Float32Array(normals.length)
  for (let i = 0; i < normals.length / 3; i++) {
    const [nx, ny, nz] = [normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]]
    const [tx, ty, tz, w] = [
      tangents![4 * i],
      tangents![4 * i + 1],
      tangents![4 * i + 2],
      tangents![4 * i + 3],
    ]
    const [x, y, z] = [w * (ny * tz - nz * ty), w * (nz * tx - nx * tz), w * (nx * ty - ny * tx)]
    const length = Math.hypot(x, y, z) || 1
    out.set([x / length, y / length, z / length], 3 * i)
  }
  return out
}

/** Both edges of a triangle, each times the change of u and of v along the other: what the gradients are made of. */
function edges(
  { positions, uvs, normals }: BakeMesh,
  corner: number,
  u: Float64Array,
  v: Float64Array,
): void {
  const at = (i: number, k: number) => positions[3 * (corner + i) + k] - positions[3 * corner + k]
  const uv = (i: number, k: number) => uvs[2 * (corner + i) + k] - uvs[2 * corner + k]
  const e = [0, 1, 2].map((k) => at(1, k)) as [number, number, number]
  const f = [0, 1, 2].map((k) => at(2, k)) as [number, number, number]
  const face = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]]
  // On the screen the axes turn to the left as seen from the front, whatever the order of the corners.
  const side = [0, 1, 2].reduce((sum, k) => sum + face[k] * normals[3 * corner + k], 0) < 0 ? -1 : 1
  for (let k = 0; k < 3; k++) {
    u[k] = side * f[k] * uv(1, 0)
    u[3 + k] = side * e[k] * uv(2, 0)
    v[k] = side * f[k] * uv(1, 1)
    v[3 + k] = side * e[k] * uv(2, 1)
  }
}

/**
 * three.js's getTangentFrame (Schueler, Normal Mapping Without Precomputed Tangents, ShaderX 5, 2006), with the two edges
 * for the two axes of the screen, and green towards smaller v: GLTFLoader turns normalScale.y for meshes without tangents.
 */
function derivativeFrame(
  u: Float64Array,
  v: Float64Array,
  n: Float64Array,
  t: Float64Array,
  b: Float64Array,
): void {
  for (let k = 0; k < 3; k++) {
    const [k1, k2] = [(k + 1) % 3, (k + 2) % 3]
    t[k] = u[k1] * n[k2] - u[k2] * n[k1] + (n[k1] * u[3 + k2] - n[k2] * u[3 + k1])
    b[k] = -(v[k1] * n[k2] - v[k2] * n[k1] + (n[k1] * v[3 + k2] - n[k2] * v[3 + k1]))
  }
  const longer = Math.sqrt(Math.max(t[0] ** 2 + t[1] ** 2 + t[2] ** 2, b[0] ** 2 + b[1] ** 2 + b[2] ** 2))
  for (let k = 0; k < 3; k++) {
    t[k] /= longer
    b[k] /= longer
  }
}

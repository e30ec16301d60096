/** Computes the exact result of baking a fine sphere onto a coarse sphere: heights, and normals in the tangent frames of different renderers. */

import sharp from 'sharp'
import { cross, degreesBetween, dot, minus, unit, type Vector } from '../../vectors.ts'
import type { globe } from './spheres.ts'

const add = (...terms: [number, Vector][]): Vector =>
  [0, 1, 2].map((k) => terms.reduce((sum, [share, v]) => sum + share * v[k]!, 0)) as Vector
/** Radii of the coarse and of the fine sphere, metres. The fine one is 3 mm outside the vertices of the coarse one. */
export const [LOW, HIGH] = [0.1, 0.103]
export const [COLUMNS, ROWS, TILT] = [24, 12, 0.2]

type Globe = ReturnType<typeof globe>
type Place = { triangle: Vector; weights: Vector }
type Frame = (shape: Globe, place: Place) => [Vector, Vector, Vector]

export const corner = (values: number[], i: number, size = 3) =>
  values.slice(size * i, size * i + 3) as Vector
const mix = (values: number[], { triangle, weights }: Place, of = (v: Vector, _: number) => v): Vector =>
  add(
    ...([0, 1, 2] as const).map(
      (k) => [weights[k], of(corner(values, triangle[k]), triangle[k])] as [number, Vector],
    ),
  )

/** Returns the tangent frame of glTF, interpolated between vertices. `sign` is -1 for mirrored UVs, else 1. `tangent` returns a vertex's tangent. */
const vertexFrame =
  (sign: number, tangent: (p: Vector, n: Vector) => Vector): Frame =>
  (shape, place) => {
    const tangentAt = (n: Vector, i: number) => add([sign, unit(tangent(corner(shape.positions, i), n))])
    const t = unit(mix(shape.normals, place, tangentAt))
    const b = unit(mix(shape.normals, place, (n, i) => add([sign, unit(cross(n, tangentAt(n, i)))])))
    return [t, b, unit(mix(shape.normals, place))]
  }

/** Frame with the tangents stored in own.glb: horizontal, perpendicular to the normal. */
export const ownFrame = (sign: number) => vertexFrame(sign, (_, n) => [n[2], 0, -n[0]])

/** Frame with MikkTSpace tangents: the direction of u on the surface, here east, made perpendicular to the normal. */
export const mikkFrame = (sign: number) =>
  vertexFrame(sign, (p, n) => {
    const east: Vector = unit([p[2], 0, -p[0]])
    return add([1, east], [-dot(east, n), n])
  })

/** Frame that three.js computes in the shader for meshes without tangents. A pixel is a step of 0.02 to 0.11 mm on the triangle. */
export const screenFrame: Frame = (shape, place) => {
  const [p0, p1, p2] = place.triangle.map((i) => corner(shape.positions, i)) as [Vector, Vector, Vector]
  const [s0, s1, s2] = place.triangle.map((i) => shape.uvs.slice(2 * i, 2 * i + 2)) as [
    number[],
    number[],
    number[],
  ]
  const [e, f] = [minus(p1, p0), minus(p2, p0)]
  const n = unit(mix(shape.normals, place))
  // Steps to the neighbouring pixels, in barycentric coordinates. Seen from outside, the second step points left of the first.
  const steps = [
    [0.003, 0.001],
    [-0.0005, 0.002],
  ] as const
  const [q0, q1] = steps.map(([a, b]) => add([a, e], [b, f])) as [Vector, Vector]
  const [st0, st1] = steps.map(([a, b]) => [0, 1].map((k) => a * (s1[k]! - s0[k]!) + b * (s2[k]! - s0[k]!)))
  const [q1perp, q0perp] = [cross(q1, n), cross(n, q0)]
  const t = add([st0![0]!, q1perp], [st1![0]!, q0perp])
  const b = add([st0![1]!, q1perp], [st1![1]!, q0perp])
  const scale = 1 / Math.sqrt(Math.max(dot(t, t), dot(b, b)))
  // The bitangent is negated, because GLTFLoader negates normalScale.y for meshes without tangents.
  return [add([scale, t]), add([-scale, b]), n]
}

/** Finds the triangle of the coarse sphere at the texture coordinates (u, v), and the barycentric coordinates in it. */
export function placeOf({ indices, uvs }: Globe, u: number, v: number): Place | undefined {
  for (let i = 0; i < indices.length; i += 3) {
    const triangle = indices.slice(i, i + 3) as Vector
    const [x, y] = [0, 1].map((k) => triangle.map((c) => uvs[2 * c + k]!)) as [Vector, Vector]
    const det = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
    const b = ((u - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (v - y[0])) / det
    const c = ((x[1] - x[0]) * (v - y[0]) - (u - x[0]) * (y[1] - y[0])) / det
    if (b >= 0 && c >= 0 && b + c <= 1) return { triangle, weights: [1 - b - c, b, c] }
  }
  return undefined
}

/** Intersects the fine sphere with the ray along the normal of a point. Returns the height above the mesh and the exact normal. */
export function exact(shape: Globe, place: Place): { height: number; normal: Vector } {
  const p = mix(shape.positions, place)
  const n = unit(mix(shape.normals, place))
  const half = dot(p, n)
  const height = -half + Math.sqrt(half * half - dot(p, p) + HIGH * HIGH)
  return { height, normal: add([1 / HIGH, add([1, p], [height, n])]) }
}

export async function readPixels(path: string) {
  const image = sharp(path)
  const { depth, channels } = await image.metadata()
  const wide = depth === 'ushort'
  image.toColourspace(channels === 1 ? (wide ? 'grey16' : 'b-w') : wide ? 'rgb16' : 'srgb')
  const { data, info } = await image
    .raw({ depth: wide ? 'ushort' : 'uchar' })
    .toBuffer({ resolveWithObject: true })
  const values = wide ? new Uint16Array(data.buffer, data.byteOffset, data.length / 2) : new Uint8Array(data)
  return { ...info, values, full: wide ? 65535 : 255 }
}

/** Border of the texture to skip, 0..1. At the border, MikkTSpace averages over triangles of one side only. */
const RIM = 0.05 + 0.9 / ROWS

/**
 * Tests every third texel of a normal map in both directions. Returns the largest `angle` between a decoded normal and the fine sphere, and the
 * largest angle by which a normal is `tilted` in its tangent frame, degrees.
 */
export async function worst(path: string, shape: Globe, frame: Frame) {
  const { values, width, full } = await readPixels(path)
  let angle = 0
  let tilted = 0
  for (let y = 0; y < width; y += 3) {
    for (let x = 0; x < width; x += 3) {
      const [u, v] = [(x + 0.5) / width, (y + 0.5) / width]
      const place = placeOf(shape, u, v)
      if (!place || Math.min(u, v, 1 - u, 1 - v) < RIM) continue
      const i = 3 * (y * width + x)
      const [r, g, b] = [0, 1, 2].map((k) => (2 * values[i + k]!) / full - 1) as Vector
      const [t, s, n] = frame(shape, place)
      angle = Math.max(angle, degreesBetween(add([r, t], [g, s], [b, n]), exact(shape, place).normal))
      tilted = Math.max(tilted, degreesBetween([r, g, b], [0, 0, 1]))
    }
  }
  return { angle, tilted }
}

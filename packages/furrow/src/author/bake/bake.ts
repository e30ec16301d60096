import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import type { GrayImage } from '../../core/types.ts'
import { boundingBoxSize } from '../../math/bounds.ts'
import { uvArea } from '../../math/triangle.ts'
import { dilate } from '../dilate.ts'
import type { NormalMap } from '../relief/relief-to-normal.ts'
import type { HeightMap } from '../strokes/height.ts'
import { type BakeMesh, sharedNormals } from './mesh.ts'
import { type Blocked, openness } from './occlusion.ts'
import { frameOf, interpolate } from './tangent-frame.ts'

/** The detailed surface, as rays see it. Directions are unit vectors, lengths are metres. */
export interface BakeTarget {
  /**
   * Finds the nearest hit within `far` on the outside of the surface and writes its distance and the shading normal there
   * into `hit` (four numbers). Returns false where there is none.
   */
  nearest(
    x: number,
    y: number,
    z: number,
    dx: number,
    dy: number,
    dz: number,
    far: number,
    hit: Float64Array,
  ): boolean
  /** Whether anything, inside or outside, lies on the way; for occlusion alone. */
  blocked: Blocked
}

export interface BakeOptions {
  /** Side of the maps in texels. */
  size?: number
  /** How far the detailed surface may lie outside or inside the low one, in metres. */
  cage: number
  /** Rays per texel: 1, 4, 9 or 16. */
  samples?: number
  /** Rays per sample for the occlusion; 0 = no occlusion. */
  occlusionRays?: number
  /** How far away something still occludes, in metres. */
  occlusionReach?: number
  /** How many texels the islands are carried outwards. */
  margin?: number
  /** Bits per channel of the normal map. */
  bits?: 8 | 16
}

export const BAKE_DEFAULTS = {
  size: 1024,
  samples: 4,
  occlusionRays: 0,
  occlusionReach: Number.POSITIVE_INFINITY,
  margin: 16,
  bits: 8,
} as const satisfies Omit<BakeOptions, 'cage'>

export interface Baked {
  /** Green towards smaller v. */
  normal: NormalMap
  height: HeightMap
  /** 255 = sees the whole sky. */
  occlusion?: GrayImage
  /** Samples that lay on the mesh, and those of them whose ray met nothing. */
  samples: number
  misses: number
  /** Texels of the mesh's islands none of whose rays met anything; they were filled from beside them, or left flat. */
  emptyTexels: number
}

/** Lifts the origins of occlusion rays off the surface, as a share of the mesh's size: float32 hits are not exact. */
const LIFT = 1e-4

/**
 * Bakes a detailed surface into maps of a low mesh. From every sample a ray goes from `cage` outside the mesh inwards
 * against its smooth normals; the first hit within twice the cage gives the normal, written in the frame in which
 * renderers read the map, and the height above the mesh. Samples are averaged per texel; where islands overlap, all
 * count. `progress` is told about how many samples of how many are done.
 * Throws FurrowError where mesh or options make no sense.
 */
export function bakeMaps(
  mesh: BakeMesh,
  target: BakeTarget,
  options: BakeOptions,
  progress?: (done: number, total: number) => void,
): Baked {
  const settings = { ...BAKE_DEFAULTS, ...options }
  const { size, cage, samples, occlusionRays, occlusionReach, margin, bits } = settings
  check(mesh, settings)
  const grid = Math.sqrt(samples)
  const texels = size * size
  const normals = new Float32Array(3 * texels)
  const heights = new Float32Array(texels)
  const open = new Float32Array(occlusionRays > 0 ? texels : 0)
  const hits = new Uint16Array(texels)
  const touched = new Uint8Array(texels)
  const frame = frameOf(mesh)
  const outwards = sharedNormals(mesh)
  const [way, at, hit, normal, tangent] = Array.from({ length: 5 }, () => new Float64Array(4)) as Vectors
  const lift = LIFT * sizeOf(mesh)
  const total = Math.max(1, Math.round(coveredSamples(mesh, size * grid)))
  let done = 0
  let misses = 0

  const sample = (first: number, a: number, b: number, c: number, texel: number, seed: number) => {
    if (++done % 16384 === 0) progress?.(Math.min(done, total), total)
    touched[texel] = 1
    interpolate(outwards, 3, first, a, b, c, way)
    for (let k = 0; k < 3; k++) {
      const i = 3 * first + k
      at[k] = a * mesh.positions[i] + b * mesh.positions[i + 3] + c * mesh.positions[i + 6] + cage * way[k]
    }
    const [dx, dy, dz] = [-way[0], -way[1], -way[2]]
    if (!target.nearest(at[0], at[1], at[2], dx, dy, dz, 2 * cage, hit)) {
      misses++
      return
    }
    for (let k = 0; k < 3; k++) normal[k] = hit[k + 1]
    if (!frame.toTangent(a, b, c, normal, tangent)) tangent.set([0, 0, 1])
    const length = Math.sqrt(tangent[0] ** 2 + tangent[1] ** 2 + tangent[2] ** 2) || 1
    for (let k = 0; k < 3; k++) normals[3 * texel + k] += tangent[k] / length
    heights[texel] += 1000 * (cage - hit[0])
    if (occlusionRays > 0) {
      for (let k = 0; k < 3; k++) at[k] += -way[k] * hit[0] + lift * normal[k]
      open[texel] += openness(target.blocked, at, normal, occlusionRays, occlusionReach, seed)
    }
    hits[texel] = Math.min(hits[texel] + 1, 65535)
  }
  for (let first = 0; first < mesh.positions.length / 3; first += 3) {
    frame.triangle(first)
    scan(mesh, first, size, grid, sample)
  }
  progress?.(total, total)
  if (done === misses) throw nothingMet(done, cage)

  const known = new Uint8Array(texels)
  let emptyTexels = 0
  for (let i = 0; i < texels; i++) {
    if (hits[i] === 0) {
      emptyTexels += touched[i]
      normals[3 * i + 2] = 1
      if (open.length > 0) open[i] = 1
      continue
    }
    known[i] = 1
    heights[i] /= hits[i]
    if (open.length > 0) open[i] /= hits[i]
  }
  const maps = [
    { data: normals, channels: 3 },
    { data: heights, channels: 1 },
  ]
  if (open.length > 0) maps.push({ data: open, channels: 1 })
  dilate(known, size, maps, margin)
  return {
    normal: { width: size, height: size, data: encode(normals, bits) },
    height: { width: size, height: size, data: heights },
    ...(open.length > 0 && {
      occlusion: {
        width: size,
        height: size,
        data: Uint8Array.from(open, (share) => Math.round(255 * share)),
      },
    }),
    samples: done,
    misses,
    emptyTexels,
  }
}

type Vectors = [Float64Array, Float64Array, Float64Array, Float64Array, Float64Array]

/** Calls `visit` for every sample whose place in the texture lies in the triangle. */
function scan(
  { uvs }: BakeMesh,
  first: number,
  size: number,
  grid: number,
  visit: (first: number, a: number, b: number, c: number, texel: number, seed: number) => void,
): void {
  const side = size * grid
  const x = [0, 1, 2].map((i) => uvs[2 * (first + i)] * side - 0.5) as [number, number, number]
  const y = [0, 1, 2].map((i) => uvs[2 * (first + i) + 1] * side - 0.5) as [number, number, number]
  const det = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
  if (Math.abs(det) < 1e-9) return
  for (let row = Math.ceil(Math.min(...y)); row <= Math.max(...y); row++) {
    const texelRow = Math.floor(wrap(row, side) / grid) * size
    for (let column = Math.ceil(Math.min(...x)); column <= Math.max(...x); column++) {
      const b = ((column - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (row - y[0])) / det
      const c = ((x[1] - x[0]) * (row - y[0]) - (column - x[0]) * (y[1] - y[0])) / det
      const a = 1 - b - c
      if (a < -1e-9 || b < -1e-9 || c < -1e-9) continue
      const across = wrap(column, side)
      visit(first, a, b, c, texelRow + Math.floor(across / grid), wrap(row, side) * side + across)
    }
  }
}

const wrap = (i: number, side: number) => ((i % side) + side) % side

/** About how many samples lie on the mesh: its area in the texture. */
function coveredSamples({ uvs }: BakeMesh, side: number): number {
  let sum = 0
  for (let i = 0; 2 * i < uvs.length; i += 3) sum += uvArea(uvs, i, i + 1, i + 2)
  return sum * side * side
}

/** Diagonal of the box round a mesh, in metres. */
export function sizeOf({ positions }: Pick<BakeMesh, 'positions'>): number {
  return Math.hypot(...boundingBoxSize(positions))
}

/** Unit vectors, 0 to the middle of the range. */
function encode(normals: Float32Array, bits: 8 | 16): Uint8Array | Uint16Array {
  const out = new (bits === 8 ? Uint8Array : Uint16Array)(normals.length)
  const half = (2 ** bits - 1) / 2
  for (let i = 0; i < normals.length; i += 3) {
    const [x, y, z] = [normals[i], normals[i + 1], normals[i + 2]]
    const length = Math.sqrt(x * x + y * y + z * z) || 1
    out[i] = Math.round((1 + x / length) * half)
    out[i + 1] = Math.round((1 + y / length) * half)
    out[i + 2] = Math.round((1 + z / length) * half)
  }
  return out
}

function check(mesh: BakeMesh, { size, cage, samples }: Required<BakeOptions>): void {
  const fail = (what: string, value: unknown, limit: string, remedy: string) => {
    throw new FurrowError({ who: 'bakeMaps', what, value, limit, remedy })
  }
  const corners = mesh.positions.length / 3
  if (corners < 3 || corners % 3 !== 0) fail('no triangles', corners, 'three corners each', 'check the mesh')
  const fits = mesh.normals.length === 3 * corners && mesh.uvs.length === 2 * corners
  if (!fits || (mesh.tangents && mesh.tangents.length !== 4 * corners)) {
    fail('arrays of the mesh differ in length', mesh.uvs.length, `${corners} corners`, 'check the mesh')
  }
  // A longer triangle would repeat the texture across itself, or be absurd, and is never meant.
  for (let i = 0; i < mesh.uvs.length; i++) {
    const apart = mesh.uvs[i] - mesh.uvs[i - (i % 6) + (i % 2)]
    if (!(Math.abs(apart) <= 1)) {
      fail('a triangle is larger than the texture', apart, 'at most 1 along u and v', 'unwrap the mesh')
    }
  }
  if (!Number.isInteger(size) || size < 1 || size > MAX_IMAGE_SIDE) {
    fail('size out of range', size, `1..${MAX_IMAGE_SIDE} texels`, 'choose e.g. 1024')
  }
  if (!(cage > 0 && cage < 1e6)) fail('cage out of range', cage, 'above 0 metres', 'choose e.g. 0.005')
  if (![1, 4, 9, 16].includes(samples)) fail('samples out of range', samples, '1, 4, 9, 16', 'choose 4')
}

function nothingMet(samples: number, cage: number): FurrowError {
  return new FurrowError({
    who: 'bakeMaps',
    what: samples === 0 ? 'no triangle covers a texel' : 'no ray met the detailed surface',
    value: `${samples} rays`,
    limit: `surfaces within ${1000 * cage} mm of each other`,
    remedy: 'put both meshes in one place and size, or widen the cage',
  })
}

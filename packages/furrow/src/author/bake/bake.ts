import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'
import type { GrayImage } from '../../core/types.ts'
import { interpolate } from '../../math/barycentrics.ts'
import { boundingBoxSize } from '../../math/bounds.ts'
import { rasterize } from '../../math/rasterize.ts'
import { uvArea, uvToTexels } from '../../math/triangle.ts'
import { length } from '../../math/vector.ts'
import { dilate } from '../border.ts'
import type { NormalMap } from '../normals/bump-to-normal.ts'
import type { HeightMap } from '../strokes/height.ts'
import { type BakeMesh, sharedNormals } from './mesh.ts'
import { type AnyHit, ambientVisibility } from './occlusion.ts'
import { interpolateUnit, type TangentSpace, tangentSpaceOf } from './tangent-frame.ts'

/** Detailed surface that rays are cast against. A ray starts at (x, y, z) and has the unit direction (dx, dy, dz). Lengths are in metres. */
export interface BakeSource {
  /**
   * Finds the nearest hit within `far` metres on a triangle that faces the ray. Writes four numbers into `hit`: the distance and the shading
   * normal. Returns false if nothing is hit.
   */
  closestHit(
    x: number,
    y: number,
    z: number,
    dx: number,
    dy: number,
    dz: number,
    far: number,
    hit: Float64Array,
  ): boolean
  /** Used only for occlusion. */
  anyHit: AnyHit
}

/** Options of {@link bakeMaps}; defaults are {@link BAKE_DEFAULTS}. */
export interface BakeOptions {
  /** Width and height of the maps in texels. */
  size?: number
  /** Maximum distance of the detailed surface from the low-polygon mesh, outwards or inwards, in metres. */
  cage: number
  /** Rays per texel: 1, 4, 9 or 16. */
  samples?: number
  /** Occlusion rays per sample; 0 = no occlusion map. */
  occlusionRays?: number
  /** Maximum distance of occluders in metres. */
  occlusionReach?: number
  /** Width in texels by which UV islands are dilated. */
  margin?: number
  /** Bits per channel of the normal map. */
  bits?: 8 | 16
}

/** Defaults of {@link BakeOptions}; `cage` has none. */
export const BAKE_DEFAULTS = {
  size: 1024,
  samples: 4,
  occlusionRays: 0,
  occlusionReach: Number.POSITIVE_INFINITY,
  margin: 16,
  bits: 8,
} as const satisfies Omit<BakeOptions, 'cage'>

/** Maps baked by {@link bakeMaps}, with statistics of the rays. */
export interface BakedMaps {
  /** Tangent-space normal map. Green points towards smaller v. */
  normal: NormalMap
  height: HeightMap
  /** 255 = unoccluded. */
  occlusion?: GrayImage
  /** Number of samples, each with one ray. */
  samples: number
  /** Number of rays that hit nothing. */
  misses: number
  /** Number of texels in UV islands whose rays hit nothing. These texels are filled from their neighbours, or stay flat. */
  emptyTexels: number
}

/**
 * Distance from the surface to the origins of occlusion rays, as a fraction of the mesh's diagonal. Hit positions are rounded to float32, so
 * rays from the surface itself could hit it.
 */
const BIAS = 1e-4

/** Barycentric tolerance. Both triangles at an edge include the samples on the edge, so that rounding loses no sample. */
const TOLERANCE = 1e-9

/**
 * Bakes a detailed surface into normal, height and occlusion maps of a low-polygon mesh. Each sample casts one ray inwards along the mesh's
 * smooth normal, from a point at distance `cage` outside the mesh. The nearest hit within `2 * cage` defines the height and the normal of the
 * sample. Normals are stored in the tangent frame that renderers use. The samples of a texel are averaged, even if islands overlap.
 *
 * @param progress called periodically with the approximate number of finished samples and their total number.
 * @throws FurrowError if the mesh or the options are invalid, or no ray hits anything.
 */
export function bakeMaps(
  mesh: BakeMesh,
  source: BakeSource,
  options: BakeOptions,
  progress?: (done: number, total: number) => void,
): BakedMaps {
  const settings = { ...BAKE_DEFAULTS, ...options }
  const { size, cage, samples, occlusionRays, occlusionReach, margin, bits } = settings
  check(mesh, settings)
  const grid = Math.sqrt(samples)
  const texels = size * size
  const normals = new Float32Array(3 * texels)
  const heights = new Float32Array(texels)
  const visibility = new Float32Array(occlusionRays > 0 ? texels : 0)
  const hits = new Uint16Array(texels)
  const touched = new Uint8Array(texels)
  const tangentSpace = tangentSpaceOf(mesh)
  const outwards = sharedNormals(mesh)
  const [direction, origin, normal, tangent] = Array.from({ length: 4 }, () => new Float64Array(3))
  const hit = new Float64Array(4)
  const bias = BIAS * meshDiagonal(mesh)
  const total = Math.max(1, Math.round(countSamples(mesh, size * grid)))
  let done = 0
  let misses = 0

  const sample = (first: number, a: number, b: number, c: number, texel: number, seed: number) => {
    if (++done % 16384 === 0) progress?.(Math.min(done, total), total)
    touched[texel] = 1
    interpolateUnit(direction, outwards, 3, first, a, b, c)
    interpolate(origin, mesh.positions, 3, first, first + 1, first + 2, a, b, c)
    for (let k = 0; k < 3; k++) {
      origin[k] += cage * direction[k]
      direction[k] = -direction[k]
    }
    const [x, y, z] = [origin[0], origin[1], origin[2]]
    if (!source.closestHit(x, y, z, direction[0], direction[1], direction[2], 2 * cage, hit)) {
      misses++
      return
    }
    for (let k = 0; k < 3; k++) normal[k] = hit[k + 1]
    if (!tangentSpace.encode(a, b, c, normal, tangent)) tangent.set([0, 0, 1])
    const scale = Math.sqrt(tangent[0] ** 2 + tangent[1] ** 2 + tangent[2] ** 2) || 1
    for (let k = 0; k < 3; k++) normals[3 * texel + k] += tangent[k] / scale
    heights[texel] += 1000 * (cage - hit[0])
    if (occlusionRays > 0) {
      for (let k = 0; k < 3; k++) origin[k] += direction[k] * hit[0] + bias * normal[k]
      visibility[texel] += ambientVisibility(
        source.anyHit,
        origin,
        normal,
        occlusionRays,
        occlusionReach,
        seed,
      )
    }
    hits[texel] = Math.min(hits[texel] + 1, 65535)
  }
  visitSamples(mesh, tangentSpace, size, grid, sample)
  progress?.(total, total)
  if (done === misses) throw noHitError(done, cage)

  const known = new Uint8Array(texels)
  let emptyTexels = 0
  for (let i = 0; i < texels; i++) {
    if (hits[i] === 0) {
      emptyTexels += touched[i]
      normals[3 * i + 2] = 1
      if (visibility.length > 0) visibility[i] = 1
      continue
    }
    known[i] = 1
    heights[i] /= hits[i]
    if (visibility.length > 0) visibility[i] /= hits[i]
  }
  const maps = [
    { data: normals, channels: 3 },
    { data: heights, channels: 1 },
  ]
  if (visibility.length > 0) maps.push({ data: visibility, channels: 1 })
  dilate(known, size, maps, margin)
  return {
    normal: { width: size, height: size, data: encode(normals, bits) },
    height: { width: size, height: size, data: heights },
    ...(visibility.length > 0 && {
      occlusion: {
        width: size,
        height: size,
        data: Uint8Array.from(visibility, (fraction) => Math.round(255 * fraction)),
      },
    }),
    samples: done,
    misses,
    emptyTexels,
  }
}

type VisitSample = (first: number, a: number, b: number, c: number, texel: number, seed: number) => void

/** Visits the samples of each triangle, after selecting the triangle in `tangentSpace`. UVs outside 0..1 wrap. */
function visitSamples(
  { uvs }: BakeMesh,
  tangentSpace: TangentSpace,
  size: number,
  grid: number,
  visit: VisitSample,
): void {
  const side = size * grid
  const triangle = new Float64Array(6)
  for (let first = 0; 2 * first < uvs.length; first += 3) {
    tangentSpace.select(first)
    uvToTexels(triangle, uvs, first, first + 1, first + 2, side, side)
    rasterize(triangle, TOLERANCE, (column, row, a, b, c) => {
      const [x, y] = [wrap(column, side), wrap(row, side)]
      visit(first, a, b, c, Math.floor(y / grid) * size + Math.floor(x / grid), y * side + x)
    })
  }
}

const wrap = (i: number, side: number) => ((i % side) + side) % side

/** Estimates the number of samples from the mesh's area in UV space. */
function countSamples({ uvs }: BakeMesh, side: number): number {
  let sum = 0
  for (let i = 0; 2 * i < uvs.length; i += 3) sum += uvArea(uvs, i, i + 1, i + 2)
  return sum * side * side
}

/** Returns the diagonal of the mesh's bounding box in metres. */
export function meshDiagonal({ positions }: Pick<BakeMesh, 'positions'>): number {
  return length(boundingBoxSize(positions))
}

/** Normalises the normals, and maps their components from -1..1 to the full range of the bit depth. */
function encode(normals: Float32Array, bits: 8 | 16): Uint8Array | Uint16Array {
  const out = new (bits === 8 ? Uint8Array : Uint16Array)(normals.length)
  const half = (bits === 8 ? 0xff : 0xffff) / 2
  for (let i = 0; i < normals.length; i += 3) {
    const [x, y, z] = [normals[i], normals[i + 1], normals[i + 2]]
    const scale = Math.sqrt(x * x + y * y + z * z) || 1
    out[i] = Math.round((1 + x / scale) * half)
    out[i + 1] = Math.round((1 + y / scale) * half)
    out[i + 2] = Math.round((1 + z / scale) * half)
  }
  return out
}

function check(mesh: BakeMesh, { size, cage, samples }: Required<BakeOptions>): void {
  const fail = (problem: string, value: unknown, limit: string, remedy: string) => {
    throw new FurrowError({ who: 'bakeMaps', problem, value, limit, remedy })
  }
  const corners = mesh.positions.length / 3
  if (corners < 3 || corners % 3 !== 0) fail('no triangles', corners, 'three corners each', 'check the mesh')
  const fits = mesh.normals.length === 3 * corners && mesh.uvs.length === 2 * corners
  if (!fits || (mesh.tangents && mesh.tangents.length !== 4 * corners)) {
    fail('arrays of the mesh differ in length', mesh.uvs.length, `${corners} corners`, 'check the mesh')
  }
  // A triangle larger than the texture would cover the same texels several times, so its UVs must be wrong.
  for (let i = 0; i < mesh.uvs.length; i++) {
    const extent = mesh.uvs[i] - mesh.uvs[i - (i % 6) + (i % 2)]
    if (!(Math.abs(extent) <= 1)) {
      fail('a triangle is larger than the texture', extent, 'at most 1 along u and v', 'unwrap the mesh')
    }
  }
  if (!Number.isInteger(size) || size < 1 || size > MAX_IMAGE_SIDE) {
    fail('size out of range', size, `1..${MAX_IMAGE_SIDE} texels`, 'choose e.g. 1024')
  }
  if (!(cage > 0 && cage < 1e6)) fail('cage out of range', cage, 'above 0 metres', 'choose e.g. 0.005')
  if (![1, 4, 9, 16].includes(samples)) fail('samples out of range', samples, '1, 4, 9, 16', 'choose 4')
}

function noHitError(samples: number, cage: number): FurrowError {
  return new FurrowError({
    who: 'bakeMaps',
    problem: samples === 0 ? 'no triangle covers a texel' : 'no ray hit the detailed surface',
    value: `${samples} rays`,
    limit: `surfaces within ${1000 * cage} mm of each other`,
    remedy: 'align both meshes in position and scale, or widen the cage',
  })
}

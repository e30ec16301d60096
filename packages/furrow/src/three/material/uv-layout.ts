import type { BufferGeometry } from 'three'
import { triangleNormal, uvArea } from '../../math/triangle.ts'
import { coordinates, trianglesOf } from '../sources/geometry-arrays.ts'

/**
 * How much more of the surface a unit of texture coordinates covers where it covers most, than on average. On the shipped faces, by the
 * narrower side of a texel, all but a thousandth of the skin is below 1.5.
 */
const UNEVENNESS = 1.5

/** How a texture lies on a surface. */
export interface UvLayout {
  /** Units of positions that one unit of texture coordinates covers, where it covers most; Infinity if the geometry does not tell. */
  unitsPerUv: number
  /** Whether all texture coordinates are in 0..1. */
  isInside: boolean
}

/** By geometry and set of texture coordinates. */
const known = new WeakMap<BufferGeometry, UvLayout[]>()

/** How a texture lies on a geometry; found once. */
export function uvLayoutOf(geometry: BufferGeometry, channel: number): UvLayout {
  const layouts = known.get(geometry) ?? []
  known.set(geometry, layouts)
  layouts[channel] ??= measure(geometry, channel)
  return layouts[channel]
}

function measure(geometry: BufferGeometry, channel: number): UvLayout {
  const { attributes } = geometry
  const uv = attributes[channel === 0 ? 'uv' : `uv${channel}`]
  if (!uv) return { unitsPerUv: Infinity, isInside: false }
  const positions = coordinates(attributes.position)
  const uvs = coordinates(uv, 2)
  const triangles = trianglesOf(geometry)
  const normal = new Float64Array(3)
  let surface = 0
  let covered = 0
  for (let i = 0; i + 2 < triangles.length; i += 3) {
    triangleNormal(normal, positions, triangles[i], triangles[i + 1], triangles[i + 2])
    surface += Math.hypot(normal[0], normal[1], normal[2]) / 2
    covered += uvArea(uvs, triangles[i], triangles[i + 1], triangles[i + 2])
  }
  const unitsPerUv = covered > 0 ? UNEVENNESS * Math.sqrt(surface / covered) : Infinity
  return { unitsPerUv, isInside: uvs.every((value) => value >= 0 && value <= 1) }
}

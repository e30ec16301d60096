import type { Uv } from '../../../core/json.ts'
import { MIN_TEXELS } from '../../furrows/furrows.ts'
import type { FurrowRegion, Furrows } from '../../furrows/read-furrows.ts'
import { FURROW_WIDTH } from '../../furrows/scatter.ts'
import { cornersOf, crossOf, skinVertices } from '../../skin/surface.ts'
import { barycentricsAt } from '../../skin/walk.ts'
import type { AutoRegion } from '../anatomy/region-names.ts'
import type { MissingRegion } from '../fit/fit-driver.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import { ageOfNet, netRegionsOf } from './net-regions.ts'

export const FURROW_LAYER = 'furrows'

/** Activation of furrows at rest. It is lower on stretched skin and higher on compressed skin. */
export const AT_REST = 0.5

/** Furrows are drawn only if at least this fraction of the regions can have them, because they need an additional layer. */
const MIN_COVERAGE = 0.5

/** Region with furrows. Positions of its spheres are in face coordinates. */
export interface PlannedRegion {
  name: string
  spheres: readonly { position: readonly [number, number, number]; radius: number }[]
}

/** Pattern of fine furrows of a face, before it is drawn. */
export interface PlannedNet {
  regions: readonly PlannedRegion[]
  /** Parameters of the pattern, as in a strokes document. */
  furrows: Furrows
}

export interface NetSettings {
  age: number
  strength: number
  /** Width and height of the maps in texels. */
  size: number
  seed: number
  /** Regions that the user requested. */
  regions: readonly AutoRegion[]
}

/**
 * Chooses the regions of a face that get fine furrows, and the size and depth of the furrows.
 *
 * @returns `net` is undefined if no region was requested, or if fewer than half of the requested regions can have furrows. `missing` lists the
 * requested regions without furrows.
 */
export function planNet(
  prepared: PreparedSkin & { face: DetectedFace },
  { age, strength, size, seed, regions }: NetSettings,
): { net: PlannedNet | undefined; missing: MissingRegion[] } {
  const { chart, landmarks } = prepared.face
  const missing: MissingRegion[] = []
  const planned: PlannedRegion[] = []
  const documented: FurrowRegion[] = []
  for (const region of netRegionsOf(landmarks, age)) {
    if (!region.regions.some((name) => regions.includes(name))) continue
    const spheres = region.spheres.flatMap(({ centre, radius }) => {
      const found = chart.find(centre)
      return found ? [{ ...found, radius }] : []
    })
    if (spheres.length === 0) {
      missing.push({ name: region.name, reason: 'the mesh has no skin there' })
      continue
    }
    const texel =
      spheres.reduce((sum, { triangle }) => sum + texelSize(prepared, triangle, size), 0) / spheres.length
    const width = FURROW_WIDTH * region.size
    if (width < MIN_TEXELS * texel) {
      missing.push({ name: region.name, reason: tooNarrowMessage(width, texel, size) })
      continue
    }
    planned.push({ name: region.name, spheres })
    for (const { triangle, position, radius } of spheres) {
      const depth = (region.depth * strength) / AT_REST
      documented.push({
        at: uvOf(prepared, triangle, position),
        radius,
        size: rounded(region.size),
        depth: rounded(depth),
      })
    }
  }
  if (planned.length < MIN_COVERAGE * (planned.length + missing.length)) {
    const reason = 'too few regions can have fine furrows'
    return { net: undefined, missing: [...missing, ...planned.map(({ name }) => ({ name, reason }))] }
  }
  if (documented.length === 0) return { net: undefined, missing }
  const [{ size: usual, depth }] = documented
  const furrows = {
    size: usual,
    depth,
    stretch: rounded(ageOfNet(age).stretch),
    seed,
    layer: FURROW_LAYER,
    regions: documented,
  }
  return { net: { regions: planned, furrows }, missing }
}

/** Returns the texel size in millimetres on a triangle: the square root of a texel's area. */
function texelSize({ skin, surface }: PreparedSkin, triangle: number, size: number): number {
  const [a, b, c] = skinVertices(skin, surface, triangle)
  const uv = (vertex: number) => [skin.uvs[2 * vertex], skin.uvs[2 * vertex + 1]] as const
  const [[u0, v0], [u1, v1], [u2, v2]] = [uv(a), uv(b), uv(c)]
  const texels = size ** 2 * Math.abs((u1 - u0) * (v2 - v0) - (u2 - u0) * (v1 - v0))
  return Math.sqrt(crossOf(surface.points, ...cornersOf(surface, triangle), new Float64Array(3)) / texels)
}

/** Returns the reason why a region is missing. `width` is the width of a furrow, `texel` the size of a texel, both in millimetres. */
function tooNarrowMessage(width: number, texel: number, size: number): string {
  let enough = size
  while (width * enough < MIN_TEXELS * texel * size) enough *= 2
  return `fine furrows are narrower than two texels there; use a size of ${enough}`
}

function uvOf({ surface, locator }: PreparedSkin, triangle: number, position: ArrayLike<number>): Uv {
  const weights = new Float64Array(3)
  barycentricsAt(weights, surface, triangle, position)
  const [u, v] = locator.uvAt(triangle, weights)
  return [rounded(u), rounded(v)]
}

function rounded(value: number): number {
  return Math.round(1e4 * value) / 1e4
}

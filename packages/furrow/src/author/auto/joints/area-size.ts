import { uvArea } from '../../../math/triangle.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import type { JointRegion } from './crease-joints.ts'

/** Sizes of areas' maps in texels, and the maximum number of areas for each, which limits the memory to 8 MB. */
const SIZES = [
  [128, 64],
  [256, 64],
  [512, 32],
] as const
/** Maximum width of a texel, as a fraction of the reach of the smallest region. */
const FINE = 0.75
/** Creases narrower than this number of texels look broken. */
const MIN_WIDTH = 1.5
/** Sizes of maps that the warning may recommend. */
const LARGER = [1024, 2048, 4096]

type Measured = Pick<PreparedSkin, 'surface' | 'skin'>

/** Returns the size of the areas' maps: large enough that each area of a joint has several texels. */
export function areaSizeFor(prepared: Measured, regions: readonly JointRegion[]): number {
  if (regions.length === 0) return SIZES[0][0]
  const reach = Math.min(...regions.map(({ region }) => region.reach))
  const side = textureSide(prepared)
  const allowed = SIZES.filter(([, count]) => regions.length <= count).map(([size]) => size)
  return allowed.find((size) => side / size <= FINE * reach) ?? allowed[allowed.length - 1]
}

/** Minimum number of texels per fold of cloth, and minimum size of its maps. */
const FOLD_TEXELS = 12
const MIN_CLOTH_SIZE = 256

/**
 * Returns the size of the maps of cloth. Folds are wide, so smaller maps than requested often show them as well, and take a quarter of the
 * memory.
 */
export function clothMapSize(prepared: Measured, regions: readonly JointRegion[], size: number): number {
  const fold = Math.min(...regions.map(({ region }) => region.spacing))
  const texel = textureSide(prepared) / size
  const isFineAt = (factor: number) => factor * texel <= fold / FOLD_TEXELS && size / factor >= MIN_CLOTH_SIZE
  let factor = 1
  while (Number.isInteger(size / (2 * factor)) && isFineAt(2 * factor)) factor *= 2
  return size / factor
}

/** Returns a warning if half of the creases are narrower than the texels of the maps can show. */
export function coarseWarnings(prepared: Measured, regions: readonly JointRegion[], size: number): string[] {
  const widths = regions.flatMap(({ strokes }) => strokes.map(({ width }) => width)).sort((a, b) => a - b)
  if (widths.length === 0) return []
  const width = widths[widths.length >> 1]
  const side = textureSide(prepared)
  if (MIN_WIDTH * side <= width * size) return []
  const fine = LARGER.find((larger) => larger > size && MIN_WIDTH * side <= width * larger)
  const remedy = fine === undefined ? 'choose the largest size' : `choose the size ${fine}`
  return [
    `creases of hands or neck look coarse, because a texel covers ${(side / size).toFixed(1)} mm of skin: ${remedy}`,
  ]
}

/** Returns the width of the texture on the skin in millimetres, on average. */
function textureSide({ surface, skin }: Measured): number {
  const { uvs, indices } = skin
  let covered = 0
  for (let t = 0; t + 2 < indices.length; t += 3)
    covered += uvArea(uvs, indices[t], indices[t + 1], indices[t + 2])
  const area = surface.areas.reduce((sum, value) => sum + value, 0)
  return covered > 0 ? Math.sqrt(area / covered) : 0
}

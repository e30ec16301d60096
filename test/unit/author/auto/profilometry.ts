import { type AutoWrinkles, type Skin, skinCanvas } from 'furrow/author'
import { driven } from '../../../driven.ts'

/** Scan direction per region, across its wrinkle lines. Lines are horizontal on the forehead, and vertical at the glabella. */
const SCANNED = {
  foreheadInnerLeft: 'down',
  crowsFeetLeft: 'down',
  glabellaLeft: 'across',
  nasolabialLeft: 'across',
} as const

export type ScannedRegion = keyof typeof SCANNED
export const SCANNED_REGIONS = Object.keys(SCANNED) as ScannedRegion[]

/** Profile of the wrinkles in a region, millimetres, as studies with profilometry report it. */
export interface Profile {
  /** Mean depth of the deepest tenth of all valleys, measured from the lower of the two crests beside a valley. */
  depth: number
  /** Median width of valleys at half depth. */
  width: number
  /** Median distance between adjacent valleys; undefined for a region with one line. */
  spacing: number | undefined
}

interface Valley {
  depth: number
  width: number
  /** Distance to the next valley of the scan line. */
  spacing: number | undefined
}

/** Depth below which a valley counts as noise, as a fraction of the greatest depth in the height map. */
const NOISE = 0.15
/** Minimum area weight, 0..255, of the texels that belong to the region. */
const WITHIN = 128

/** Measures the profile of the wrinkle lines of a region at full activation, along rows or columns of the height map. */
export function measureProfile(skin: Skin, wrinkles: AutoWrinkles, region: ScannedRegion): Profile {
  const area = wrinkles.areas.find(({ name }) => name === region)
  if (!area) throw new Error(`no area ${region}`)
  const map = wrinkles.layers[area.layer].heights
  const { width: size } = map
  const { uu, vv } = skinCanvas(skin, size, size, wrinkles.scale).metric
  const isDown = SCANNED[region] === 'down'
  const deepest = map.data.reduce((most, height) => Math.max(most, -height), 0)
  const valleys: Valley[] = []
  for (let line = 0; line < size; line++) {
    const heights: number[] = []
    const positions: number[] = [0]
    for (let i = 0; i < size; i++) {
      const texel = isDown ? i * size + line : line * size + i
      const [u, v] = [texel % size, Math.floor(texel / size)].map((k) =>
        Math.floor((k * area.weights.width) / size),
      )
      const isWithin = area.weights.data[v * area.weights.width + u] >= WITHIN
      heights.push(isWithin ? map.data[texel] : Number.NaN)
      positions.push(positions[i] + Math.sqrt((isDown ? vv : uu)[texel] || 0) / size)
    }
    valleys.push(...valleysOf(heights, positions, NOISE * deepest))
  }
  const depths = valleys.map(({ depth }) => depth).sort((a, b) => b - a)
  const tenth = depths.slice(0, Math.ceil(depths.length / 10))
  const spacings = valleys.flatMap(({ spacing }) => spacing ?? [])
  return {
    depth: tenth.reduce((a, b) => a + b, 0) / tenth.length,
    width: median(valleys.map(({ width }) => width)),
    spacing: spacings.length > valleys.length / 10 ? median(spacings) : undefined,
  }
}

/** Returns the activation of a region of a resting face at an age. */
export function restingFraction(wrinkles: AutoWrinkles, region: ScannedRegion, age: number): number {
  const ageing = wrinkles.areas.find(({ name }) => name === region)?.ageing
  return ageing ? driven([ageing]).activations({ inputs: { age } })[region] : 0
}

/** Finds the valleys of a scan: minima between two crests. The depth of a valley is measured from the lower crest. */
function valleysOf(heights: readonly number[], positions: readonly number[], noise: number): Valley[] {
  const found: (Valley & { at: number })[] = []
  for (let i = 1; i + 1 < heights.length; i++) {
    if (!(heights[i] < heights[i - 1] && heights[i] <= heights[i + 1])) continue
    const [left, right] = [crestFrom(heights, i, -1), crestFrom(heights, i, 1)]
    const depth = Math.min(heights[left], heights[right]) - heights[i]
    if (!(depth > noise)) continue
    const half = heights[i] + depth / 2
    let [from, to] = [i, i]
    while (heights[from] < half) from--
    while (heights[to] < half) to++
    const before = found.at(-1)
    if (before) before.spacing = positions[i] - positions[before.at]
    found.push({ at: i, depth, width: positions[to] - positions[from], spacing: undefined })
  }
  return found
}

/** Returns the index of the next crest beside a valley: where the skin falls again, or the region ends. */
function crestFrom(heights: readonly number[], valley: number, step: 1 | -1): number {
  let i = valley
  while (heights[i + step] >= heights[i]) i += step
  return i
}

function median(values: number[]): number {
  return values.sort((a, b) => a - b)[Math.floor(values.length / 2)]
}

import { type AutoWrinkles, type Skin, skinCanvas } from 'furrow/author'
import { driven } from '../../../driven.ts'

/** How a scan line meets the lines of a region: those of the forehead are one above the other, those of the glabella side by side. */
const SCANNED = {
  foreheadInnerLeft: 'down',
  crowsFeetLeft: 'down',
  glabellaLeft: 'across',
  nasolabialLeft: 'across',
} as const

export type ScannedRegion = keyof typeof SCANNED
export const SCANNED_REGIONS = Object.keys(SCANNED) as ScannedRegion[]

/** The profile of a region as profilometry reports it, in millimetres. */
export interface Profile {
  /** From the deepest valley to the skin beside it: the mean of the deepest tenth of all valleys. */
  depth: number
  /** Of valleys at half their depth, the median. */
  width: number
  /** From a valley to the next one, the median; none where a region has one line. */
  spacing: number | undefined
}

interface Valley {
  depth: number
  width: number
  /** To the next valley of the scan line. */
  spacing: number | undefined
}

/** Depth below which a valley is noise, as a fraction of the deepest. */
const NOISE = 0.15
/** Weight of an area from which on texels are the region's. */
const WITHIN = 128

/** Measures the profile that a region's lines are drawn with, fully shown: rows or columns of the height map as scan lines. */
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

/** What of a region's depth shows at rest at an age. */
export function restingFraction(wrinkles: AutoWrinkles, region: ScannedRegion, age: number): number {
  const ageing = wrinkles.areas.find(({ name }) => name === region)?.ageing
  return ageing ? driven([ageing]).activations({ inputs: { age } })[region] : 0
}

/** The valleys of a scan line: lowest between two crests, by how far they are below the lower of both. */
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

/** Upwards from a valley to the next crest, which is where the skin falls again or the region ends. */
function crestFrom(heights: readonly number[], valley: number, step: 1 | -1): number {
  let i = valley
  while (heights[i + step] >= heights[i]) i += step
  return i
}

function median(values: number[]): number {
  return values.sort((a, b) => a - b)[Math.floor(values.length / 2)]
}

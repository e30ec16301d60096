import { type CreasedRegion, creaseLines, type LineStyle, type SkinRegion } from './crease.ts'
import { layFreeLines } from './free-lines.ts'
import { lossAt } from './principal.ts'
import { Random } from './random.ts'
import { strainOf, TENSOR } from './strain.ts'
import type { Surface } from './surface.ts'

/** Millimetres over which strain is evened: no anatomy tells a spot from noise. */
const EVEN = 5
/** Compression from which on skin may crease: more than where anatomy is known. */
const LEAST = 0.07
/** Square millimetres below which a spot is none. */
const SMALLEST = 80
/** Share of the smaller of two spots that both have in common, from which on they are one. */
const COMMON = 0.5
const SPACING = 6
const STYLE: LineStyle = { width: 3, depth: 1, taper: [0.4, 0.4], shoulder: [0.9, 0.9], softness: 0.5 }

/** Skin that one or several targets push together. */
interface Spot {
  points: ReadonlySet<number>
  surface: number
  /** Index of the target that does so most. */
  target: number
}

/**
 * Regions of a skin of which nothing is known but what its targets do to it: connected spots that they push together, the largest
 * first. More cautious than anatomy: only strong compression creases, and not deeply.
 *
 * @param age 0 at 20 years, 1 at 80.
 * @param most regions that there may be.
 */
export function strainRegions(
  surface: Surface,
  offsets: readonly Float64Array[],
  names: readonly string[],
  age: number,
  strength: number,
  seed: number,
  most: number,
): CreasedRegion[] {
  const strainBy = (target: number) => strainOf(surface, offsets, new Map([[target, 1]]), EVEN)
  const spots = names.flatMap((_, target) => spotsOf(surface, strainBy(target), target))
  const chosen: Spot[] = []
  for (const spot of spots.sort((a, b) => b.surface - a.surface)) {
    if (chosen.length === most) break
    if (!chosen.some((other) => isSame(spot, other))) chosen.push(spot)
  }
  const used = new Map<string, number>()
  return chosen.flatMap((spot): CreasedRegion[] => {
    const name = names[spot.target]!
    const numbers = new Random(seed, name)
    const tensors = strainBy(spot.target)
    keepOnly(tensors, spot.points)
    const laid = layFreeLines(surface, tensors, { spacing: SPACING, least: LEAST, style: STYLE })
    const lines = laid.map((line) => ({ ...line, style: varied(numbers) }))
    if (lines.length === 0) return []
    const times = (used.get(name) ?? 0) + 1
    used.set(name, times)
    const region: SkinRegion = {
      name: times === 1 ? name : `${name} ${times}`,
      cause: { [name]: 1 },
      spacing: SPACING,
      hidden: 0.25 + 0.35 * age,
      deepest: 0.4 + 0.4 * age,
      reach: 4,
      feather: 6,
    }
    return [{ region, ...creaseLines(region, lines, strength) }]
  })
}

/** Lines as deep and as wide as each other would look like stripes. */
function varied(numbers: Random): LineStyle {
  const end = () => numbers.between(0.3, 0.5)
  return {
    ...STYLE,
    width: STYLE.width * numbers.between(0.85, 1.1),
    depth: numbers.between(0.7, 1),
    taper: [end(), end()],
  }
}

/** Connected points that lose enough. */
function spotsOf(surface: Surface, tensors: Float64Array, target: number): Spot[] {
  const { areas, starts, neighbours } = surface
  const open = new Set<number>()
  for (let i = 0; i < areas.length; i++) if (lossAt(surface, tensors, i) >= LEAST) open.add(i)
  const spots: Spot[] = []
  for (const first of open) {
    const points = new Set([first])
    open.delete(first)
    for (const point of points) {
      for (let n = starts[point]!; n < starts[point + 1]!; n++) {
        const next = neighbours[n]!
        if (open.delete(next)) points.add(next)
      }
    }
    const size = [...points].reduce((sum, point) => sum + areas[point]!, 0)
    if (size >= SMALLEST) spots.push({ points, surface: size, target })
  }
  return spots
}

function isSame(a: Spot, b: Spot): boolean {
  let common = 0
  for (const point of a.points) if (b.points.has(point)) common++
  return common >= COMMON * Math.min(a.points.size, b.points.size)
}

function keepOnly(tensors: Float64Array, points: ReadonlySet<number>): void {
  for (let i = 0; i < tensors.length; i++) if (!points.has(Math.floor(i / TENSOR))) tensors[i] = 0
}

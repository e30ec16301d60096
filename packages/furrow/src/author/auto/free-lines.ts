import type { SurfacePlace } from './chart.ts'
import type { LaidLine, LineStyle } from './crease.ts'
import { crossed, principalAt } from './principal.ts'
import type { Surface } from './surface.ts'
import { type Direction, STEP, type Trace, traceLine } from './trace.ts'

/** Share of the spacing that a new line keeps from all others where it begins, and where it goes on. */
const APART = 0.9
const CLOSEST = 0.6
/** Length in spacings below which a line is none. */
const SHORTEST = 1.5
/** Longest line in millimetres. */
const LONGEST = 120

/** What free lines are laid by. */
export interface FreeLines {
  /** Millimetres from line to line. */
  spacing: number
  /** Compression that skin must lose for a line to go on. */
  least: number
  style: LineStyle
}

/**
 * Lays lines on skin of which nothing is known but its strain: across the direction in which it is shortened most, evenly spaced (Jobard and
 * Lefer 1997, Creating evenly-spaced streamlines of arbitrary density), beginning where it is shortened most.
 */
export function layFreeLines(
  surface: Surface,
  tensors: Float64Array,
  { spacing, least, style }: FreeLines,
): LaidLine[] {
  const taken = new TakenPoints(spacing)
  const lines: LaidLine[] = []
  const queue: SurfacePlace[] = strongest(surface, tensors, least)
  for (let next = queue.shift(); next; next = queue.shift()) {
    if (taken.distance(next.point) < APART * spacing) continue
    const line = bothWays(surface, tensors, next, least, (point) => taken.distance(point) > CLOSEST * spacing)
    if (line.lost.length * STEP < SHORTEST * spacing) continue
    taken.add(line.points)
    lines.push({ style, ...line })
    // The neighbours' beginnings, a spacing to either side, come before any other.
    queue.unshift(...besides(surface, tensors, line.places, spacing))
  }
  return lines
}

/** The triangles in whose middle the skin is shortened at least so much, the most first. */
function strongest(surface: Surface, tensors: Float64Array, least: number): SurfacePlace[] {
  const { points, corners } = surface
  const third = Float64Array.of(1 / 3, 1 / 3, 1 / 3)
  const found: { place: SurfacePlace; lost: number }[] = []
  for (let triangle = 0; triangle < corners.length / 3; triangle++) {
    const { lost } = principalAt(surface, tensors, triangle, third)
    if (lost < least) continue
    const point = [0, 1, 2].map((k) =>
      [0, 1, 2].reduce((sum, j) => sum + points[3 * corners[3 * triangle + j]! + k]! / 3, 0),
    ) as [number, number, number]
    found.push({ place: { triangle, point }, lost })
  }
  return found.sort((a, b) => b.lost - a.lost).map(({ place }) => place)
}

interface FreeLine extends Omit<LaidLine, 'style'> {
  places: SurfacePlace[]
}

function bothWays(
  surface: Surface,
  tensors: Float64Array,
  start: SurfacePlace,
  least: number,
  isFree: (point: ArrayLike<number>) => boolean,
): FreeLine {
  const [back, on] = [-1, 1].map((sense) => oneWay(surface, tensors, start, sense, least, isFree)) as [
    Way,
    Way,
  ]
  const points = [...reversed(back.points, 3), ...on.points.slice(3)]
  const normals = [...reversed(back.normals, 3), ...on.normals.slice(3)]
  return {
    points: Float64Array.from(points),
    normals: Float64Array.from(normals),
    lost: [...back.lost.slice().reverse(), ...on.lost.slice(1)],
    places: [...back.places.slice().reverse(), ...on.places.slice(1)],
  }
}

interface Way extends Trace {
  lost: number[]
  places: SurfacePlace[]
}

function oneWay(
  surface: Surface,
  tensors: Float64Array,
  start: SurfacePlace,
  sense: number,
  least: number,
  isFree: (point: ArrayLike<number>) => boolean,
): Way {
  const lost: number[] = []
  const places: SurfacePlace[] = []
  const goOn = keepSense(sense)
  const direction: Direction = (point, _, triangle, shares, out) => {
    const { way, lost: here } = principalAt(surface, tensors, triangle, shares)
    lost.push(here)
    places.push({ triangle, point: [point[0]!, point[1]!, point[2]!] })
    goOn(way, out)
    return here >= least && isFree(point)
  }
  const { points, normals } = traceLine(surface, start, direction, LONGEST)
  const count = points.length / 3
  return { points, normals, lost: lost.slice(0, count), places: places.slice(0, count) }
}

/** Places a spacing away from a line, on both sides, along its way. */
function besides(
  surface: Surface,
  tensors: Float64Array,
  places: readonly SurfacePlace[],
  spacing: number,
): SurfacePlace[] {
  const found: SurfacePlace[] = []
  const every = Math.max(1, Math.round(spacing / 2 / STEP))
  for (let i = 0; i < places.length; i += every) {
    for (const sense of [-1, 1]) {
      const goOn = keepSense(sense)
      let last: SurfacePlace | undefined
      const across: Direction = (point, normal, triangle, shares, out) => {
        const { way } = principalAt(surface, tensors, triangle, shares)
        goOn(crossed(normal, way), out)
        last = { triangle, point: [point[0]!, point[1]!, point[2]!] }
        return true
      }
      traceLine(surface, places[i]!, across, spacing)
      if (last) found.push(last)
    }
  }
  return found
}

/**
 * Principal directions have no sense: the first is taken as it is or turned round, each later one so that the line does not turn back.
 *
 * @param first 1 or -1.
 */
function keepSense(first: number): (way: readonly [number, number, number], out: Float64Array) => void {
  const before = new Float64Array(3)
  let isFirst = true
  return (way, out) => {
    const same = way[0] * before[0]! + way[1] * before[1]! + way[2] * before[2]!
    const turn = isFirst ? first : Math.sign(same) || 1
    isFirst = false
    for (let k = 0; k < 3; k++) before[k] = out[k] = turn * way[k]!
  }
}

function reversed(values: readonly number[], size: number): number[] {
  const out: number[] = []
  for (let i = values.length - size; i >= 0; i -= size) out.push(...values.slice(i, i + size))
  return out
}

/** Points of lines so far, for the distance to the nearest within a spacing. */
class TakenPoints {
  readonly #cell: number
  readonly #cells = new Map<string, number[]>()

  constructor(cell: number) {
    this.#cell = cell
  }

  add(points: Float64Array): void {
    for (let i = 0; i < points.length; i += 3) {
      const key = [0, 1, 2].map((k) => Math.floor(points[i + k]! / this.#cell)).join(' ')
      const cell = this.#cells.get(key)
      if (cell) cell.push(points[i]!, points[i + 1]!, points[i + 2]!)
      else this.#cells.set(key, [points[i]!, points[i + 1]!, points[i + 2]!])
    }
  }

  /** Infinity where none is near. */
  distance(point: ArrayLike<number>): number {
    const [x, y, z] = [0, 1, 2].map((k) => Math.floor(point[k]! / this.#cell)) as [number, number, number]
    let least = Infinity
    for (let i = x - 1; i <= x + 1; i++) {
      for (let j = y - 1; j <= y + 1; j++) {
        for (let k = z - 1; k <= z + 1; k++) {
          const cell = this.#cells.get(`${i} ${j} ${k}`) ?? []
          for (let at = 0; at < cell.length; at += 3) {
            least = Math.min(
              least,
              Math.hypot(cell[at]! - point[0]!, cell[at + 1]! - point[1]!, cell[at + 2]! - point[2]!),
            )
          }
        }
      }
    }
    return least
  }
}

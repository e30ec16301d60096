import { smoothstep } from '../../math/scalar.ts'
import type { Guide } from './anatomy/region.ts'
import { type Chart, rollUp, type Spot, unroll } from './chart.ts'
import type { LaidLine } from './crease.ts'
import { between, crossed, tensorAt } from './principal.ts'
import { along } from './strain.ts'
import type { Surface } from './surface.ts'
import { type Direction, traceLine } from './trace.ts'

/** How much a line is drawn back to its guide, per millimetre it is off. */
const PULL = 0.35
/** Share of the way to the direction of strain that a line turns, and at most so far in radians. */
const YIELD = 0.5
const LARGEST_TURN = 0.3
/** Compression from which on its direction is believed. */
const SURE = 0.05

/**
 * Lays guides on the skin: each line begins where its guide does and follows it, turned a little to where the strain is.
 *
 * @param tensors of the expression, see `compressionTensors`.
 * @returns those that begin on skin.
 */
export function layGuides(
  surface: Surface,
  chart: Chart,
  guides: readonly Guide[],
  tensors: Float64Array,
): LaidLine[] {
  return guides.flatMap((guide) => {
    const line = follow(surface, chart, guide, tensors)
    return line ? [{ style: guide, ...line }] : []
  })
}

/** A guide's line on the skin, and what share the skin loses across it at each point. */
function follow(surface: Surface, chart: Chart, { spots }: Guide, tensors: Float64Array) {
  const start = chart.find(spots[0]!)
  if (!start) return undefined
  const lost: number[] = []
  let segment = 0
  const direction: Direction = (point, normal, triangle, shares, out) => {
    const here = unroll(point[0]!, point[1]!, point[2]!)
    while (segment < spots.length - 1 && passed(here, spots[segment]!, spots[segment + 1]!)) segment++
    const isOver = segment === spots.length - 1
    const [from, to] = [
      spots[Math.min(segment, spots.length - 2)]!,
      spots[Math.min(segment + 1, spots.length - 1)]!,
    ]
    rollUp(point[0]!, point[2]!, normal, wayBack(here, from, to), out)
    const tensor = tensorAt(surface, tensors, triangle, shares)
    if (!isOver) turnToStrain(tensor, normal, out)
    lost.push(acrossLoss(tensor, normal, out))
    return !isOver
  }
  const trace = traceLine(surface, start, direction, 2 * lengthOf(spots))
  // Three points at least: a line has a beginning, a middle and an end.
  if (trace.points.length < 9) return undefined
  const points = Float64Array.from(trace.points)
  return { points, normals: Float64Array.from(trace.normals), lost: lost.slice(0, points.length / 3) }
}

function passed(here: Spot, from: Spot, to: Spot): boolean {
  return (here[0] - to[0]) * (to[0] - from[0]) + (here[1] - to[1]) * (to[1] - from[1]) >= 0
}

/** Along a piece of the guide, and back to it. */
function wayBack(here: Spot, from: Spot, to: Spot): Spot {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]]
  const length = Math.hypot(dx, dy) || 1
  const off = ((here[0] - from[0]) * dy - (here[1] - from[1]) * dx) / length
  return [dx / length - (PULL * off * dy) / length, dy / length + (PULL * off * dx) / length]
}

function lengthOf(spots: readonly Spot[]): number {
  let sum = 0
  for (let i = 1; i < spots.length; i++)
    sum += Math.hypot(spots[i]![0] - spots[i - 1]![0], spots[i]![1] - spots[i - 1]![1])
  return sum
}

/** What the skin loses at a right angle to a direction. */
function acrossLoss(tensor: Float64Array, normal: Float64Array, way: Float64Array): number {
  return along(tensor, 0, ...crossed(normal, way))
}

/** Turns a direction towards the one along which the skin is shortened least. */
function turnToStrain(tensor: Float64Array, normal: Float64Array, way: Float64Array): void {
  const [ax, ay, az] = crossed(normal, way)
  const t = tensor
  const lengthwise = along(t, 0, way[0]!, way[1]!, way[2]!)
  const crosswise = along(t, 0, ax, ay, az)
  const mixed = between(t, way, [ax, ay, az])
  // The principal axes lie at half the angle of the deviator (Mohr's circle). Where the skin is shortened along the line rather than
  // across it, or hardly at all, strain has nothing to say.
  const doubled = Math.atan2(-2 * mixed, crosswise - lengthwise)
  const trust = Math.max(0, Math.cos(doubled)) * smoothstep(crosswise / SURE)
  const turn = Math.min(Math.max((YIELD * trust * doubled) / 2, -LARGEST_TURN), LARGEST_TURN)
  const [c, s] = [Math.cos(turn), Math.sin(turn)]
  way[0] = c * way[0]! + s * ax
  way[1] = c * way[1]! + s * ay
  way[2] = c * way[2]! + s * az
}

import { atan2, cos, sin } from '../../../math/elementary.ts'
import { clamp, smoothstep } from '../../../math/scalar.ts'
import { cross, length2 } from '../../../math/vector.ts'
import type { SkinSurface } from '../../skin/surface.ts'
import type { Guide } from '../anatomy/region.ts'
import { type ChartPoint, type HeadChart, rollUp, unroll } from '../surface/head-chart.ts'
import { bilinearForm, compressionAlong, tensorAt } from '../surface/tensors.ts'
import { type LaidLine, MIN_POINTS } from './laid-line.ts'
import { type DirectionField, traceLine } from './trace.ts'

/** Strength with which a line is pulled back to its guide, per millimetre of distance from the guide. */
const PULL = 0.35
/** A line turns towards the direction of least compression by this fraction of the angle between them. */
const YIELD = 0.5
/** Maximum turn towards the direction of least compression, in radians. */
const MAX_TURN = 0.3
/** The direction of least compression is reliable if the compression across the line is at least this. */
const TRUSTED = 0.05

/**
 * Lays lines on the skin along guides. A line starts at the first point of its guide and follows the guide, but turns slightly towards the
 * direction in which the skin is compressed least.
 *
 * @param tensors result of `compressionTensors` for the expression.
 * @returns one line for each guide that starts on skin and is long enough.
 */
export function layGuides(
  surface: SkinSurface,
  chart: HeadChart,
  guides: readonly Guide[],
  tensors: Float64Array,
): LaidLine[] {
  return guides.flatMap((guide) => {
    const line = followGuide(surface, chart, guide, tensors)
    return line ? [{ style: guide, ...line }] : []
  })
}

function followGuide(
  surface: SkinSurface,
  chart: HeadChart,
  { path }: Guide,
  tensors: Float64Array,
): Omit<LaidLine, 'style'> | undefined {
  const start = chart.find(path[0])
  if (!start) return undefined
  const compressions: number[] = []
  const across = new Float64Array(3)
  let segment = 0
  const field: DirectionField = (position, normal, triangle, barycentrics, out) => {
    const here = unroll(position[0], position[1], position[2])
    while (segment < path.length - 1 && isPast(here, path[segment], path[segment + 1])) segment++
    const isOver = segment === path.length - 1
    const from = path[Math.min(segment, path.length - 2)]
    const to = path[Math.min(segment + 1, path.length - 1)]
    rollUp(position[0], position[2], normal, towardsGuide(here, from, to), out)
    const tensor = tensorAt(surface, tensors, triangle, barycentrics)
    if (!isOver) turnToStrain(tensor, normal, out)
    cross(across, normal, out)
    compressions.push(compressionAlong(tensor, across[0], across[1], across[2]))
    return !isOver
  }
  const trace = traceLine(surface, start, field, 2 * lengthOf(path))
  if (trace.triangles.length < MIN_POINTS) return undefined
  return {
    points: Float64Array.from(trace.points),
    triangles: trace.triangles,
    compressions: compressions.slice(0, trace.triangles.length),
  }
}

function isPast(here: ChartPoint, from: ChartPoint, to: ChartPoint): boolean {
  return (here[0] - to[0]) * (to[0] - from[0]) + (here[1] - to[1]) * (to[1] - from[1]) >= 0
}

/** Returns the direction of a guide's segment, turned towards the segment if the position is beside it. */
function towardsGuide(here: ChartPoint, from: ChartPoint, to: ChartPoint): ChartPoint {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]]
  const length = length2(dx, dy) || 1
  const distance = ((here[0] - from[0]) * dy - (here[1] - from[1]) * dx) / length
  return [dx / length - (PULL * distance * dy) / length, dy / length + (PULL * distance * dx) / length]
}

function lengthOf(path: readonly ChartPoint[]): number {
  let sum = 0
  for (let i = 1; i < path.length; i++)
    sum += length2(path[i][0] - path[i - 1][0], path[i][1] - path[i - 1][1])
  return sum
}

const perpendicular = new Float64Array(3)

/** Turns a direction in the tangent plane of the skin towards the direction of least compression. */
function turnToStrain(tensor: Float64Array, normal: Float64Array, direction: Float64Array): void {
  cross(perpendicular, normal, direction)
  const [ax, ay, az] = perpendicular
  const along = compressionAlong(tensor, direction[0], direction[1], direction[2])
  const across = compressionAlong(tensor, ax, ay, az)
  const shear = bilinearForm(tensor, direction, perpendicular)
  // Mohr's circle yields twice the angle from the line to the direction of least compression. This direction is not reliable if the skin is
  // compressed along the line rather than across it, or is hardly compressed.
  const doubleAngle = atan2(-2 * shear, across - along)
  const trust = Math.max(0, cos(doubleAngle)) * smoothstep(across / TRUSTED)
  const turn = clamp((YIELD * trust * doubleAngle) / 2, -MAX_TURN, MAX_TURN)
  const [cosine, sine] = [cos(turn), sin(turn)]
  for (let k = 0; k < 3; k++) direction[k] = cosine * direction[k] + sine * perpendicular[k]
}

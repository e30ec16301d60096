import { PointGrid } from '../../../math/point-grid.ts'
import { cross, dot } from '../../../math/vector.ts'
import { cornersOf, type SkinSurface, type SurfacePoint } from '../../skin/surface.ts'
import type { LineStyle } from '../anatomy/region.ts'
import { type PrincipalCompression, principalAt } from '../strain/principal.ts'
import { hasTensor } from '../surface/tensors.ts'
import type { LaidLine } from './laid-line.ts'
import { type DirectionField, STEP, type Trace, traceLine } from './trace.ts'

/** Minimum distance from the start of a line to other lines, as a multiple of `spacing`. */
const START_DISTANCE = 0.9
/** Minimum distance between two lines, as a multiple of `spacing`. A line ends where it comes nearer to another line. */
const MIN_DISTANCE = 0.6
/** Minimum length of a line, as a multiple of `spacing`. */
const MIN_LENGTH = 1.5
/** Maximum length of a line on each side of its starting point, in millimetres. */
const MAX_LENGTH = 120

export interface FreeLineSettings {
  /** Distance between lines in millimetres. */
  spacing: number
  /** Minimum compression of the skin for a line to continue. */
  minCompression: number
  /** Maximum total length of lines in millimetres. The most compressed skin gets lines first. */
  maxTotalLength: number
  style: LineStyle
  /** Returns a factor on the distance to the next line. Default: 1. */
  spacingFactor?: () => number
}

/** Returns the direction of creases, and the compression across them, at a position in a triangle. */
export type CreaseField = (triangle: number, barycentrics: ArrayLike<number>) => PrincipalCompression

/**
 * Lays evenly spaced lines on skin whose anatomy is not known. The lines are perpendicular to the direction of maximum compression. The first
 * line starts where the compression is largest.
 *
 * @param tensors result of `compressionTensors` for the pose that compresses the skin.
 */
export function layFreeLines(
  surface: SkinSurface,
  tensors: Float64Array,
  settings: FreeLineSettings,
): LaidLine[] {
  const fieldAt: CreaseField = (triangle, barycentrics) =>
    principalAt(surface, tensors, triangle, barycentrics)
  return layLinesAlong(surface, fieldAt, mostCompressed(surface, tensors, settings.minCompression), settings)
}

/**
 * Lays evenly spaced lines along a field of creases (Jobard and Lefer 1997, Creating evenly-spaced streamlines of arbitrary density).
 *
 * @param first starting points. Lines beside a line precede the next starting point.
 */
export function layLinesAlong(
  surface: SkinSurface,
  fieldAt: CreaseField,
  first: readonly SurfacePoint[],
  { spacing, minCompression, maxTotalLength, style, spacingFactor = () => 1 }: FreeLineSettings,
): LaidLine[] {
  const occupied = new PointGrid(spacing)
  const lines: LaidLine[] = []
  let left = maxTotalLength
  // The array is reversed so that seeds can be taken from its end: taking the first element of a long array is slow.
  const seeds = first.toReversed()
  const isFree = (position: ArrayLike<number>) => occupied.distance(position) > MIN_DISTANCE * spacing
  for (let seed = seeds.pop(); seed; seed = seeds.pop()) {
    if (occupied.distance(seed.position) < START_DISTANCE * spacing) continue
    const { path, ...line } = traceBothWays(surface, fieldAt, seed, minCompression, isFree)
    const length = path.length * STEP
    if (length < MIN_LENGTH * spacing) continue
    if (length > left) break
    left -= length
    occupied.add(line.points)
    lines.push({ style, ...line })
    // Continue with lines beside this line before starting elsewhere.
    seeds.push(...seedsBeside(surface, fieldAt, path, spacing, spacingFactor).reverse())
  }
  return lines
}

/** Returns the centroids of triangles with at least the minimum compression, sorted from most to least compressed. */
function mostCompressed(surface: SkinSurface, tensors: Float64Array, minCompression: number): SurfacePoint[] {
  const { points, corners } = surface
  const centroid = Float64Array.of(1 / 3, 1 / 3, 1 / 3)
  const found: { seed: SurfacePoint; compression: number }[] = []
  for (let triangle = 0; triangle < corners.length / 3; triangle++) {
    if (!cornersOf(surface, triangle).some((point) => hasTensor(tensors, point))) continue
    const { compression } = principalAt(surface, tensors, triangle, centroid)
    if (compression < minCompression) continue
    const middle = (k: number) =>
      cornersOf(surface, triangle).reduce((sum, point) => sum + points[3 * point + k] / 3, 0)
    found.push({ seed: { triangle, position: [middle(0), middle(1), middle(2)] }, compression })
  }
  return found.sort((a, b) => b.compression - a.compression).map(({ seed }) => seed)
}

interface Streamline extends Trace {
  compressions: number[]
  path: SurfacePoint[]
}

function traceBothWays(
  surface: SkinSurface,
  fieldAt: CreaseField,
  seed: SurfacePoint,
  minCompression: number,
  isFree: (position: ArrayLike<number>) => boolean,
): Omit<LaidLine, 'style'> & { path: SurfacePoint[] } {
  const traceOneWay = (sign: number) => traceStreamline(surface, fieldAt, seed, sign, minCompression, isFree)
  const [backward, forward] = [traceOneWay(-1), traceOneWay(1)]
  return {
    points: Float64Array.from([...reversed(backward.points), ...forward.points.slice(3)]),
    triangles: [...backward.triangles.slice().reverse(), ...forward.triangles.slice(1)],
    compressions: [...backward.compressions.slice().reverse(), ...forward.compressions.slice(1)],
    path: [...backward.path.slice().reverse(), ...forward.path.slice(1)],
  }
}

function traceStreamline(
  surface: SkinSurface,
  fieldAt: CreaseField,
  seed: SurfacePoint,
  sign: number,
  minCompression: number,
  isFree: (position: ArrayLike<number>) => boolean,
): Streamline {
  const compressions: number[] = []
  const path: SurfacePoint[] = []
  const orient = consistentSign(sign)
  const field: DirectionField = (position, _, triangle, barycentrics, out) => {
    const { direction, compression } = fieldAt(triangle, barycentrics)
    compressions.push(compression)
    path.push({ triangle, position: [position[0], position[1], position[2]] })
    orient(direction, out)
    return compression >= minCompression && isFree(position)
  }
  const { points, triangles } = traceLine(surface, seed, field, MAX_LENGTH)
  const count = points.length / 3
  return { points, triangles, compressions: compressions.slice(0, count), path: path.slice(0, count) }
}

/** Returns starting points for further lines, at a distance of about one spacing on both sides of a line. */
function seedsBeside(
  surface: SkinSurface,
  fieldAt: CreaseField,
  path: readonly SurfacePoint[],
  spacing: number,
  spacingFactor: () => number,
): SurfacePoint[] {
  const seeds: SurfacePoint[] = []
  const across = new Float64Array(3)
  const every = Math.max(1, Math.round(spacing / 2 / STEP))
  for (let i = 0; i < path.length; i += every) {
    for (const sign of [-1, 1]) {
      const orient = consistentSign(sign)
      let last: SurfacePoint | undefined
      const field: DirectionField = (position, normal, triangle, barycentrics, out) => {
        cross(across, normal, fieldAt(triangle, barycentrics).direction)
        orient(across, out)
        last = { triangle, position: [position[0], position[1], position[2]] }
        return true
      }
      traceLine(surface, path[i], field, spacing * spacingFactor())
      if (last) seeds.push(last)
    }
  }
  return seeds
}

/**
 * Returns a function that chooses the signs of principal directions along a line, because a principal direction has no sign. The first
 * direction is multiplied by `first`. The following ones get the sign with which the line does not turn back.
 *
 * @param first 1 or -1.
 */
function consistentSign(first: number): (direction: ArrayLike<number>, out: Float64Array) => void {
  const before = new Float64Array(3)
  let isFirst = true
  return (direction, out) => {
    const sign = isFirst ? first : Math.sign(dot(direction, before)) || 1
    isFirst = false
    for (let k = 0; k < 3; k++) before[k] = out[k] = sign * direction[k]
  }
}

function reversed(points: readonly number[]): number[] {
  const out: number[] = []
  for (let i = points.length - 3; i >= 0; i -= 3) out.push(...points.slice(i, i + 3))
  return out
}

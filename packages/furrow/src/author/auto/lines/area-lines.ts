import { texelAt } from '../../../core/image.ts'
import type { GrayImage } from '../../../core/types.ts'
import { cos, sin } from '../../../math/elementary.ts'
import { noise } from '../../../math/noise.ts'
import { Rng } from '../../../math/rng.ts'
import { lerp } from '../../../math/scalar.ts'
import { cross, dot, length, normalize } from '../../../math/vector.ts'
import type { SkinCanvas } from '../../skin/canvas.ts'
import type { SurfacePoint } from '../../skin/surface.ts'
import { normalAt, positionAt } from '../../skin/walk.ts'
import type { Stroke } from '../../strokes/document.ts'
import { MAX_TOTAL_LENGTH } from '../../strokes/lay-out.ts'
import { CROWS_FEET_DERMIS, DERMIS, dermisAt } from '../anatomy/dermis.ts'
import { filmWavelength } from '../buckling/film.ts'
import { creaseLines } from './crease.ts'
import { type CreaseField, layLinesAlong } from './free-lines.ts'
import { type LaidLine, MIN_POINTS } from './laid-line.ts'
import { variedStyle } from './patch-lines.ts'

/** Minimum weight of skin that gets lines, 0..1. */
const MIN_WEIGHT = 0.4
/** Assumed compression of skin with the weight 1. */
const COMPRESSION = 0.2
/** Maximum angle between a line and the long axis of the area, radians, and the distance over which it varies, millimetres. */
const TURN = 0.2
const TURN_LENGTH = 25
/** Range of factors on the distance between two lines. */
const SPACINGS = [0.95, 1.35] as const
/** Maximum part of a line that is cut off at each end, as a fraction of its length. */
const SHORTER = 0.2
/** Width of a line as a fraction of the wavelength, and its maximum as a fraction of the spacing. */
const WIDTH = 0.28
const MAX_WIDTH = 0.6
/** Factors on the spacing. The first one with at least `MIN_LINES` lines is chosen, so that small areas get lines too. */
const FACTORS = [1, 0.5, 0.25]
const MIN_LINES = 2
/** Number of iterations that find the long axis. */
const ITERATIONS = 32

export interface AreaLineSettings {
  /** Name of a region of automatic wrinkles, without its side. It determines the thickness of the skin. */
  region?: string | undefined
  /** Age in years, 20..80. */
  age: number
  /** Factor on the depth. */
  strength: number
  /** The same seed and stream produce the same lines. */
  seed: number
  /** Name of the random sequence. */
  stream: string
}

/** Returns the thickness of the dermis of a region at 20 years, millimetres. Default: that of the forehead. */
function thicknessOf(region: string | undefined): number {
  if (region === 'crowsFeet') return CROWS_FEET_DERMIS
  if (region === 'underEye') return DERMIS.lid
  return region === 'nose' || region === 'noseRoot' ? DERMIS.nose : DERMIS.forehead
}

/**
 * Fills an area with lines along its long axis, in the style of automatic wrinkles. Their distance is the wavelength at which the skin buckles;
 * see `filmWavelength`. Returns an empty list if the area is smaller than a line.
 *
 * @param weights weights of the area, which fill the texture.
 */
export function layAreaLines(canvas: SkinCanvas, weights: GrayImage, settings: AreaLineSettings): Stroke[] {
  const ageFraction = (settings.age - 20) / 60
  const wavelength = filmWavelength(dermisAt(thicknessOf(settings.region), ageFraction))
  const prepared = { ...canvas, isDrawn: () => true }
  const covered = coveredPoints(canvas, weights)
  if (covered.length === 0) return []
  const axis = longAxis(covered)
  let lines: LaidLine[] = []
  for (const factor of FACTORS) {
    const spacing = factor * wavelength
    const width = Math.min(WIDTH * wavelength, MAX_WIDTH * spacing)
    const laid = layLines(canvas, weights, covered, axis, spacing, width, settings)
    if (laid.length > lines.length) lines = laid
    if (lines.length >= MIN_LINES) break
  }
  const region = {
    name: settings.stream,
    spacing: wavelength,
    creasedFraction: lerp(0.5, 0.8, ageFraction),
    maxDepth: lerp(0.7, 1.2, ageFraction),
  }
  return [...creaseLines(prepared, region, lines, { strength: settings.strength, symmetry: 0 }).strokes]
}

function layLines(
  canvas: SkinCanvas,
  weights: GrayImage,
  covered: readonly SurfacePoint[],
  axis: Float64Array,
  spacing: number,
  width: number,
  { seed, stream }: AreaLineSettings,
): LaidLine[] {
  const { surface } = canvas
  const rng = new Rng(seed, stream)
  const fieldAt = fieldAlong(canvas, weights, axis, rng)
  const middle = nearestTo(meanOf(covered), covered)
  const laid = layLinesAlong(surface, fieldAt, [middle, ...covered], {
    spacing,
    minCompression: MIN_WEIGHT * COMPRESSION,
    maxTotalLength: MAX_TOTAL_LENGTH / 2,
    style: variedStyle(rng),
    spacingFactor: () => rng.uniform(...SPACINGS),
  })
  return laid.map((line) => shorter({ ...line, style: variedStyle(rng, width) }, rng))
}

/** Returns a field of creases along an axis, which turns a little from place to place. The compression is proportional to the area's weight. */
function fieldAlong(
  { surface, locator }: SkinCanvas,
  weights: GrayImage,
  axis: Float64Array,
  rng: Rng,
): CreaseField {
  const [first, second] = [rng.integer(), rng.integer()]
  const barycentrics = new Float64Array(3)
  const [position, normal, across] = [new Float64Array(3), new Float64Array(3), new Float64Array(3)]
  return (triangle, at) => {
    barycentrics.set(at)
    const compression = COMPRESSION * (texelAt(weights, locator.uvAt(triangle, barycentrics)) / 255)
    normalAt(normal, surface, triangle, barycentrics)
    const direction = Float64Array.from(axis)
    const height = dot(axis, normal)
    for (let k = 0; k < 3; k++) direction[k] -= height * normal[k]
    // On skin that faces along the axis, the direction is undefined.
    if (length(direction) < 0.1) return { direction, compression: 0 }
    normalize(direction)
    cross(across, normal, direction)
    positionAt(position, surface, triangle, barycentrics)
    const angle =
      (TURN / 2) *
      (noise(dot(position, axis) / TURN_LENGTH, first) + noise(dot(position, across) / TURN_LENGTH, second))
    for (let k = 0; k < 3; k++) direction[k] = cos(angle) * direction[k] + sin(angle) * across[k]
    return { direction, compression }
  }
}

/** Cuts random parts off the ends of a line, because lines of equal length look like stripes. */
function shorter(line: LaidLine, rng: Rng): LaidLine {
  const count = line.triangles.length
  const start = Math.floor(rng.uniform(0, SHORTER) * count)
  const end = count - Math.floor(rng.uniform(0, SHORTER) * count)
  if (end - start < MIN_POINTS) return line
  return {
    ...line,
    points: line.points.slice(3 * start, 3 * end),
    triangles: line.triangles.slice(start, end),
    compressions: line.compressions.slice(start, end),
  }
}

/** Returns the position of each texel whose weight is large enough for lines. */
function coveredPoints({ surface, texels }: SkinCanvas, weights: GrayImage): SurfacePoint[] {
  const found: SurfacePoint[] = []
  texels.visit((texel, triangle, a, b, c) => {
    const uv = [
      ((texel % texels.width) + 0.5) / texels.width,
      (Math.floor(texel / texels.width) + 0.5) / texels.height,
    ] as const
    if (Math.min(a, b, c) < 0 || texelAt(weights, uv) < 255 * MIN_WEIGHT) return
    const position = new Float64Array(3)
    positionAt(position, surface, triangle, Float64Array.of(a, b, c))
    found.push({ triangle, position: [position[0], position[1], position[2]] })
  })
  return found
}

function meanOf(points: readonly SurfacePoint[]): Float64Array {
  const mean = new Float64Array(3)
  for (const { position } of points) for (let k = 0; k < 3; k++) mean[k] += position[k] / points.length
  return mean
}

function nearestTo(position: ArrayLike<number>, points: readonly SurfacePoint[]): SurfacePoint {
  const distance = ({ position: [x, y, z] }: SurfacePoint) =>
    (x - position[0]) ** 2 + (y - position[1]) ** 2 + (z - position[2]) ** 2
  return points.reduce((best, point) => (distance(point) < distance(best) ? point : best))
}

/** Returns the unit direction in which points are spread most: the main eigenvector of their covariance, by power iteration. */
function longAxis(points: readonly SurfacePoint[]): Float64Array {
  const mean = meanOf(points)
  const covariance = new Float64Array(9)
  for (const { position } of points) {
    for (let i = 0; i < 9; i++)
      covariance[i] +=
        (position[Math.floor(i / 3)] - mean[Math.floor(i / 3)]) * (position[i % 3] - mean[i % 3])
  }
  // Round areas have no long axis. Their lines are nearly horizontal, as on foreheads.
  const axis = Float64Array.of(1, 0.02, 0.01)
  normalize(axis)
  for (let i = 0; i < ITERATIONS; i++) {
    const next = Float64Array.from([0, 1, 2], (row) => dot(covariance.subarray(3 * row, 3 * row + 3), axis))
    if (length(next) === 0) break
    normalize(next)
    axis.set(next)
  }
  return axis
}

import { barycentricsAt } from 'furrow/internal'
import type { SkinFilm } from '../../../packages/furrow/src/author/auto/anatomy/region.ts'
import { flatChart } from '../../../packages/furrow/src/author/auto/buckling/flat-chart.ts'
import { sampleChart } from '../../../packages/furrow/src/author/auto/buckling/sample-chart.ts'
import { filmFields } from '../../../packages/furrow/src/author/auto/lines/film-fields.ts'
import { poseDisplacements } from '../../../packages/furrow/src/author/auto/strain/pose-strain.ts'
import type { DetectedFace } from '../../../packages/furrow/src/author/auto/surface/detect-face.ts'
import { unrollPoint } from '../../../packages/furrow/src/author/auto/surface/head-chart.ts'
import { poseOf } from '../../../packages/furrow/src/author/auto/surface/pose.ts'
import { cornersOf } from '../../../packages/furrow/src/author/skin/surface.ts'
import { interpolate } from '../../../packages/furrow/src/math/barycentrics.ts'
import { mean, median } from '../../statistics.ts'
import type { SkinLine } from './skin-lines.ts'

/** Movement of the forehead by raised brows, from the brows to the hairline. */
export interface ForeheadMovement {
  /** Height above the brows at which the skin stops moving up, as a fraction of the forehead's height. */
  convergence: number
  /** Length, in millimetres, by which the blendshapes shorten the forehead. */
  shortening: number
  /**
   * Length, in millimetres, by which the compression that `autoWrinkles` computes lines from shortens the forehead. This compression is the sum
   * of the compression by the blendshapes and of the forehead muscle's pull. It fades out at the brows and the hairline.
   */
  filmShortening: number
}

const RAISED = { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 }
/** Number of points from the brows to the hairline. */
const POINTS = 101
/** Skin that moves up by less than this counts as still, millimetres. */
const STILL = 0.1
/** Largest distance from the middle, in millimetres, at which lines are counted. It is about half the distance between the pupils. */
const COUNTED = 30
/** Distance between samples of the film in millimetres. */
const SPACING = 1.5
/** Distance, in millimetres, between the verticals on which lines are counted. */
const VERTICALS = 5

/**
 * Measures how raised brows move the forehead. `convergence` and `shortening` are means over three verticals: the middle of the face and both pupils.
 *
 * @param film model of the forehead's skin as a film that buckles.
 * @param tensors compression of the skin with raised brows, see `StrainedRegion`.
 */
export function foreheadMovement(
  face: DetectedFace,
  film: SkinFilm,
  tensors: Float64Array,
): ForeheadMovement {
  const { eye } = face.landmarks
  const moved = poseDisplacements(face.surface, face.offsets, poseOf(face.find, RAISED))
  const measured = [-eye[0], 0, eye[0]].map((across) => movementAt(face, moved, across))
  return {
    convergence: mean(measured.map(({ convergence }) => convergence)),
    shortening: mean(measured.map(({ shortening }) => shortening)),
    filmShortening: filmShortening(face, film, tensors),
  }
}

/** @param displacements displacement of each point of the surface, in millimetres. */
function movementAt(
  { landmarks, chart, surface }: DetectedFace,
  displacements: Float64Array,
  across: number,
) {
  const brow = (landmarks.innerBrow[1] + landmarks.outerBrow[1]) / 2
  const [weights, displacement] = [new Float64Array(3), new Float64Array(3)]
  const path = Array.from({ length: POINTS }, (_, i) => {
    const height = i / (POINTS - 1)
    const found = chart.find([across, brow + height * (landmarks.hairline - brow)])
    if (!found) return undefined
    barycentricsAt(weights, surface, found.triangle, found.position)
    const [wa, wb, wc] = weights
    interpolate(displacement, displacements, 3, ...cornersOf(surface, found.triangle), wa!, wb!, wc!)
    return {
      height,
      position: found.position,
      moved: found.position.map((value, k) => value + displacement[k]!),
    }
  }).filter((point) => point !== undefined)
  const still = path.find(({ position, moved }) => moved[1]! - position[1] < STILL)
  return {
    convergence: still?.height ?? 1,
    shortening: lengthOf(path.map(({ position }) => position)) - lengthOf(path.map(({ moved }) => moved)),
  }
}

function lengthOf(points: readonly (readonly number[])[]): number {
  return points
    .slice(1)
    .reduce((sum, point, i) => sum + Math.hypot(...point.map((x, k) => x - points[i]![k]!)), 0)
}

/** Returns the shortening of the film, averaged over the width between the pupils. */
function filmShortening({ surface }: DetectedFace, film: SkinFilm, tensors: Float64Array): number {
  const chart = flatChart(
    surface,
    (point) => film.isFlattened(unrollPoint(surface.points, point)),
    (point) => unrollPoint(surface.points, point),
  )
  if (!chart) return 0
  const samples = sampleChart(chart, SPACING, 0)
  const { width } = samples.grid
  const [, , upwards] = filmFields(samples, film, tensors).compression
  const isCounted = (sample: number) => Math.abs(samples.origin[0] + SPACING * (sample % width)) <= COUNTED
  const sum = upwards.reduce((sum, value, sample) => sum + (isCounted(sample) ? value : 0), 0)
  return (sum * SPACING ** 2) / (2 * COUNTED)
}

/** Counts the lines that each vertical between the pupils crosses. Returns the median count. */
export function countForeheadLines(lines: readonly SkinLine[]): number {
  const paths = lines.map(({ samples }) => samples.map(({ position }) => position[0]))
  const counts = Array.from({ length: 2 * (COUNTED / VERTICALS) + 1 }, (_, i) => {
    const across = VERTICALS * i - COUNTED
    return paths.reduce((sum, path) => sum + crossings(path, across), 0)
  })
  return median(counts)
}

function crossings(path: readonly number[], across: number): number {
  return path.slice(1).filter((x, i) => x < across !== path[i]! < across).length
}

import { clamp, rounded } from '../../../math/scalar.ts'
import type { SurfacePoint } from '../../skin/surface.ts'
import { type LaidStroke, layOutStroke } from '../../strokes/lay-out.ts'
import { liftLine, sampleAt } from '../buckling/sample-chart.ts'
import { clipToDrawn, foldOf, type RegionCreases, typicalCompression } from '../lines/crease.ts'
import { keptRuns, type LaidLine } from '../lines/laid-line.ts'
import { type StrokedSkin, strokeOf } from '../lines/stroke-of.ts'
import type { BuckledCloth } from './cloth-film.ts'
import type { Ridge } from './ridges.ts'

/** Maximum fraction by which the valley on one side of a crest may be nearer than the one on the other side. */
const MAX_LEAN = 0.35

/** Number of points of a crest per factor on the height of its stroke. */
const POINTS = 3

/** Folds of cloth before they are converted to strokes. */
export interface ClothFolds {
  cloth: BuckledCloth
  ridges: readonly Ridge[]
  /** Height per point of each ridge, in millimetres. */
  heights: readonly Float64Array[]
}

/** Converts folds to strokes: bulges along their crests. Cloth rises and never sinks, because the body is below it. */
export function clothCreases(skin: StrokedSkin, { cloth, ridges, heights }: ClothFolds): RegionCreases {
  const lines = ridges.flatMap((ridge, i) => linesOf(cloth, ridge, heights[i]))
  const compression = typicalCompression(lines.flatMap(({ compressions }) => compressions))
  const lost = typicalCompression(
    ridges.flatMap(({ points, heights: own }) =>
      Array.from(own, (_, i) => cloth.lost[sampleAt(cloth.samples, points[2 * i], points[2 * i + 1])]),
    ),
  )
  const drawn = lines.flatMap((line) => clipToDrawn(line, skin))
  const strokes = drawn.map((line) => ({
    ...strokeOf(
      line,
      -line.style.depth,
      line.relativeDepths ?? [1, 1],
      undefined,
      skin,
      Math.ceil(line.triangles.length / POINTS) + 1,
    ),
    // Bulges have no banks.
    shoulder: [0, 0] as [number, number],
    softness: 0,
  }))
  const creases: LaidStroke[] = strokes.flatMap((stroke) => layOutStroke(stroke, skin))
  return {
    folds: drawn.map((line) => foldOf(line, skin)),
    strokes,
    creases,
    compression,
    ...(lost > compression + 0.005 && { lost }),
  }
}

/** Lifts a ridge onto the surface. Where the cloth has a hole, the line is cut. */
function linesOf(
  { samples, wanted }: BuckledCloth,
  { points, reach: [left, right] }: Ridge,
  heights: Float64Array,
): LaidLine[] {
  const at = (i: number) => sampleAt(samples, points[2 * i], points[2 * i + 1])
  const lifted = liftLine(samples, points)
  const width = left + right
  const lean = clamp((right - left) / width, -MAX_LEAN, MAX_LEAN)
  return keptRuns(heights.length, (i) => lifted[i] !== undefined).flatMap(([start, end]) => {
    const part = lifted.slice(start, end) as SurfacePoint[]
    const own = heights.subarray(start, end)
    const highest = Math.max(...own)
    if (!(highest > 0)) return []
    return [
      {
        style: {
          width,
          depth: highest,
          taper: [0, 0],
          shoulder: [0, 0],
          lean: rounded(lean, 1e3),
          softness: 0,
        },
        points: Float64Array.from(part.flatMap(({ position }) => [...position])),
        triangles: part.map(({ triangle }) => triangle),
        compressions: part.map((_, k) => wanted[at(start + k)]),
        relativeDepths: Array.from(own, (height) => height / highest),
      },
    ]
  })
}

import { rounded } from '../../../math/scalar.ts'
import type { SurfacePoint } from '../../skin/surface.ts'
import { type LaidStroke, layOutStroke } from '../../strokes/lay-out.ts'
import { liftPoint } from '../buckling/flat-chart.ts'
import { sampleAt } from '../buckling/sample-chart.ts'
import { clipToDrawn, foldOf, type RegionCreases } from '../lines/crease.ts'
import { keptRuns, type LaidLine } from '../lines/laid-line.ts'
import { type StrokedSkin, strokeOf } from '../lines/stroke-of.ts'
import type { BuckledCloth } from './cloth-film.ts'
import type { Ridge } from './ridges.ts'

/** Maximum fraction by which the valley on one side of a crest may be nearer than the one on the other side. */
const MAX_LEAN = 0.35
/** The compression of a region is the value that this fraction of the compressions at its crests exceeds. */
const ABOVE = 0.3

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
  const compression = typical(lines.flatMap(({ compressions }) => compressions))
  const lost = typical(
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
      line.triangles.length,
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

/** Returns the value that a part of the compressions exceeds. */
function typical(compressions: readonly number[]): number {
  const sorted = [...compressions].sort((a, b) => b - a)
  return sorted[Math.floor(ABOVE * sorted.length)] ?? 0
}

/** Lifts a ridge onto the surface. Where the cloth has a hole, the line is cut. */
function linesOf(
  { samples, wanted }: BuckledCloth,
  { points, reach: [left, right] }: Ridge,
  heights: Float64Array,
): LaidLine[] {
  const { chart, origin, triangles } = samples
  let index = -1
  const at = (i: number) => sampleAt(samples, points[2 * i], points[2 * i + 1])
  const lifted = Array.from(heights, (_, i) => {
    if (index < 0) index = triangles[at(i)]
    const found =
      index < 0
        ? undefined
        : liftPoint(chart, index, origin[0] + points[2 * i], origin[1] + points[2 * i + 1])
    index = found?.index ?? -1
    return found?.point
  })
  const width = left + right
  const lean = Math.max(-MAX_LEAN, Math.min(MAX_LEAN, (right - left) / width))
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

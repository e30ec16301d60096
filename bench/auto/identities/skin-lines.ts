import type { AutoWrinkles, Skin } from 'furrow/author'
import { crossOf, traceStroke, UvLocator, uvOf } from 'furrow/internal'
import type { DetectedFace } from '../../../packages/furrow/src/author/auto/surface/detect-face.ts'
import { type Vector, vectorAt } from '../../../test/vectors.ts'

/** Wrinkle line, sampled at even distances. */
export interface SkinLine {
  /** Name of the region without its side. Both parts of the forehead are `forehead`. */
  region: string
  /** Length in millimetres. */
  length: number
  /** Samples. */
  samples: LineSample[]
}

export interface LineSample {
  uv: readonly [u: number, v: number]
  /** Position in face coordinates, millimetres. */
  position: Vector
  /** Normal of the triangle that contains the sample. Not normalised. */
  normal: Vector
}

/** Distance between samples in millimetres. */
const STEP = 0.5

/** Returns the wrinkle lines of a face. Lines that several areas or layers share are returned once. */
export function skinLines(
  skin: Skin,
  { surface }: Pick<DetectedFace, 'surface'>,
  { layers }: Pick<AutoWrinkles, 'layers'>,
): SkinLine[] {
  const located = { surface, locator: new UvLocator(skin, surface) }
  // Only layers with lines have onset maps.
  const withLines = layers.filter(({ onset }) => onset)
  const strokes = new Map(
    withLines.flatMap(({ strokes }) => strokes).map((stroke) => [stroke.points, stroke]),
  )
  return [...strokes.values()].flatMap((stroke): SkinLine[] => {
    const traced = traceStroke(stroke, located)
    const length = traced.lengths.at(-1) ?? 0
    if (!(length > 0)) return []
    const samples: LineSample[] = []
    const normal = new Float64Array(3)
    for (let i = 0; i < traced.lengths.length; i++) {
      if (traced.lengths[i]! < samples.length * STEP) continue
      const corner = 3 * traced.triangles[i]!
      const [a, b, c] = surface.corners.subarray(corner, corner + 3)
      crossOf(surface.points, a!, b!, c!, normal)
      samples.push({
        uv: uvOf(traced, i, located),
        position: vectorAt(traced.points, i),
        normal: vectorAt(normal, 0),
      })
    }
    return [{ region: regionOf(stroke.group ?? ''), length, samples }]
  })
}

/** Returns the name of an area's region without its side. */
export function regionOf(area: string): string {
  return area.startsWith('forehead') ? 'forehead' : area.replace(/(Left|Right)$/, '')
}

import type { Uv } from '../../../core/json.ts'
import { interpolateValues, rounded } from '../../../math/scalar.ts'
import { splineKnots } from '../../../math/spline.ts'
import { barycentricsAt } from '../../skin/walk.ts'
import type { Stroke } from '../../strokes/document.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import type { LaidLine } from './laid-line.ts'
import { STEP } from './trace.ts'

/** Parts of a prepared skin that are needed to convert lines to strokes. */
export type StrokedSkin = Pick<PreparedSkin, 'surface' | 'locator' | 'isDrawn'>

/** Maximum distance in millimetres between a stroke and its line. */
const TOLERANCE = 0.08
/** Spacing of a stroke's depth factors in millimetres. */
const FACTOR_SPACING = 4

/**
 * Converts a line to a stroke: a spline through few of the line's points.
 *
 * @param depth depth of the stroke in millimetres.
 * @param factors factors on the depth, one per point of the line.
 * @param count number of depth factors of the stroke. Default: one per `FACTOR_SPACING`, if the points are `STEP` apart.
 * @param bank distances, in millimetres, from the line to the ends of its raised sides (banks). Undefined: derived from the width.
 */
export function strokeOf(
  line: LaidLine,
  depth: number,
  factors: readonly number[],
  bank: readonly [left: number, right: number] | undefined,
  skin: StrokedSkin,
  count = Math.round((line.triangles.length * STEP) / FACTOR_SPACING) + 1,
): Stroke {
  const { width, taper, shoulder, lean, softness } = line.style
  return {
    curve: 'spline',
    points: splineKnots(line.points, TOLERANCE).map((i) => uvAt(line, i, skin)),
    width: rounded(width, 1e3),
    depth: rounded(depth, 1e4),
    depths: depthsOf(factors, Math.max(2, count)),
    taper: [rounded(taper[0], 1e3), rounded(taper[1], 1e3)],
    shoulder: [rounded(shoulder[0], 1e3), rounded(shoulder[1], 1e3)],
    ...(bank && { bank: [rounded(bank[0], 100), rounded(bank[1], 100)] }),
    ...(lean !== undefined && { lean }),
    softness: rounded(softness, 1e3),
    waviness: 0,
  }
}

function depthsOf(factors: readonly number[], count: number): number[] {
  return Array.from({ length: count }, (_, i) => rounded(interpolateValues(factors, i / (count - 1)), 1e3))
}

/** Returns the UV coordinates of a point of a line. They are rounded to about 1/2000 of a texel in maps of 1024 texels. */
export function uvAt({ points, triangles }: LaidLine, i: number, { surface, locator }: StrokedSkin): Uv {
  const weights = new Float64Array(3)
  barycentricsAt(weights, surface, triangles[i], points.subarray(3 * i, 3 * i + 3))
  const [u, v] = locator.uvAt(triangles[i], weights)
  return [rounded(u, 2e6), rounded(v, 2e6)]
}

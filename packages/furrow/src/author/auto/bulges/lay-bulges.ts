import type { Uv } from '../../../core/json.ts'
import { barycentricsAt } from '../../skin/walk.ts'
import type { Stroke } from '../../strokes/document.ts'
import { type LaidStroke, layOutStroke, reachOf } from '../../strokes/lay-out.ts'
import type { MissingRegion } from '../fit/fit-driver.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import type { BulgeLine, BulgeRegion } from './bulge-region.ts'

/** Skin of a face, on which bulges are laid. */
export type BulgingSkin = Pick<PreparedSkin, 'surface' | 'locator' | 'isDrawn'> & {
  face: Pick<DetectedFace, 'chart'>
}

/** Region of a face with its bulges. */
export interface LaidBulge {
  name: string
  strokes: readonly Stroke[]
  /** The strokes, laid on the skin. */
  creases: readonly LaidStroke[]
  /** Distance from the strokes, in millimetres, beyond which the bulges are flat. */
  reach: number
}

/**
 * Lays the bulges of regions on the skin.
 *
 * @param strength factor on the heights.
 */
export function layBulges(
  skin: BulgingSkin,
  regions: readonly BulgeRegion[],
  strength: number,
): { laid: LaidBulge[]; missing: MissingRegion[] } {
  const laid: LaidBulge[] = []
  const missing: MissingRegion[] = []
  for (const { name, lines } of regions) {
    const [main, ...others] = lines.map((line) => strokeOf(skin, line, strength))
    const strokes = [main, ...others].filter((stroke) => stroke !== undefined)
    const creases = strokes.flatMap((stroke) => layOutStroke(stroke, skin))
    if (!main || creases.length === 0) missing.push({ name, reason: 'the mesh has no skin there' })
    else laid.push({ name, strokes, creases, reach: Math.max(...creases.map(reachOf)) })
  }
  return { laid, missing }
}

/** Minimum fraction of a line's points at which the mesh has skin. */
const MIN_SKIN = 0.7

/** Converts a line to a stroke. Returns undefined if the mesh has no skin at many of its points. */
function strokeOf(skin: BulgingSkin, line: BulgeLine, strength: number): Stroke | undefined {
  const points = line.path.map((point) => uvAt(skin, point)).filter((point) => point !== undefined)
  if (points.length < MIN_SKIN * line.path.length) return undefined
  return {
    curve: 'spline',
    points,
    width: line.width,
    depth: Math.round(-1e3 * strength * line.height) / 1e3,
    ...(line.heights && { depths: [...line.heights] }),
    taper: [...line.taper],
    shoulder: [0, 0],
    ...(line.lean !== undefined && { lean: line.lean }),
    softness: 1,
    waviness: 0,
  }
}

/** Returns the UV coordinates of the outermost skin at a chart point; undefined without drawn skin. */
function uvAt({ surface, locator, isDrawn, face }: BulgingSkin, point: ChartPoint): Uv | undefined {
  const found = face.chart.find(point)
  if (!found || !isDrawn(found.triangle)) return undefined
  const weights = new Float64Array(3)
  barycentricsAt(weights, surface, found.triangle, Float64Array.from(found.position))
  const [u, v] = locator.uvAt(found.triangle, weights)
  const uv: Uv = [Math.round(2e6 * u) / 2e6, Math.round(2e6 * v) / 2e6]
  return uv.every((value) => value >= 0 && value <= 1) ? uv : undefined
}

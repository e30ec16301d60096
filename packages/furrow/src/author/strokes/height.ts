import type { GrayImage } from '../../core/types.ts'
import { lerp } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import type { Stroke } from './document.ts'
import { type LaidStroke, layOutStrokes } from './lay-out.ts'
import { LineGrid } from './line-grid.ts'
import { visitTexelsNearLines } from './near-lines.ts'
import { profile, REACH } from './profile.ts'

/** Relief of the skin. */
export interface HeightMap {
  width: number
  height: number
  /** Millimetres above (+) or below (-) the smooth skin, width x height values, row 0 is v = 0. */
  data: Float32Array
}

/** The relief of strokes, and how open to the light it is. */
export interface DrawnStrokes {
  relief: HeightMap
  /** 255 = open. */
  occlusion: GrayImage
}

/**
 * Exponent of the smooth maximum that joins strokes: (a^6 + b^6)^(1/6) is the larger of two, at most 12% more where they are
 * equal. Valleys that cross are as deep as the deeper one, not as both together.
 */
const JOIN = 6
/** Fraction of the light that a valley loses, per depth in half widths, and at most. */
const SHADE = 1.1
const MAX_SHADE = 0.75
/** Segments of strokes that are drawn at once: bounds the memory of the grid. */
const BATCH = 20_000

/**
 * Draws strokes as a height map. Distances are measured in space, so that neither the texture's stretch nor its seams show. Valleys are joined
 * with valleys and banks with banks (see JOIN), then added, so the order of the strokes does not matter and a single stroke keeps its exact
 * profile. No valley is drawn sharper than a texel. Strokes, or parts of them, that are not on the skin are left out.
 *
 * @param progress is called with the strokes drawn so far, one or another in part.
 * @throws FurrowError where they are longer than 100 m together.
 */
export function strokesToHeight(
  strokes: readonly Stroke[],
  canvas: SkinCanvas,
  progress?: (done: number, total: number) => void,
): HeightMap {
  const parts = layOutStrokes(strokes, canvas)
  return drawStrokes(parts, canvas, progress).relief
}

/**
 * Draws strokes that are laid on the skin already.
 *
 * @param strokes the parts of each.
 */
export function drawStrokes(
  strokes: readonly (readonly LaidStroke[])[],
  canvas: Pick<SkinCanvas, 'texels' | 'metric'>,
  progress?: (done: number, total: number) => void,
): DrawnStrokes {
  const { width, height } = canvas.metric
  const valleys = new Float64Array(width * height)
  const banks = new Float64Array(width * height)
  const shades = new Float32Array(width * height)
  let batch: LaidStroke[] = []
  let [segments, drawn] = [0, 0]
  for (const [i, parts] of strokes.entries()) {
    batch.push(...parts)
    segments += parts.reduce((sum, { depths }) => sum + depths.length, 0)
    if (segments < BATCH && i + 1 < strokes.length) continue
    const first = drawn
    drawn = i + 1
    drawBatch(batch, canvas, { valleys, banks, shades }, (fraction) =>
      progress?.(lerp(first, drawn, fraction), strokes.length),
    )
    ;[batch, segments] = [[], 0]
  }
  const data = new Float32Array(width * height)
  for (let i = 0; i < data.length; i++) {
    if (valleys[i] !== 0 || banks[i] !== 0) data[i] = banks[i] ** (1 / JOIN) - valleys[i] ** (1 / JOIN)
  }
  const open = Uint8Array.from(shades, (shade) => Math.round(255 * (1 - Math.min(MAX_SHADE, shade))))
  return { relief: { width, height, data }, occlusion: { width, height, data: open } }
}

/** Sums of powers of heights, and the darkest shade, per texel. */
interface Sums {
  valleys: Float64Array
  banks: Float64Array
  shades: Float32Array
}

function drawBatch(
  strokes: readonly LaidStroke[],
  { texels, metric }: Pick<SkinCanvas, 'texels' | 'metric'>,
  { valleys, banks, shades }: Sums,
  progress: (fraction: number) => void,
): void {
  const reaches = strokes.map(({ halfWidths }) => REACH * halfWidths.reduce((a, b) => Math.max(a, b), 0))
  const grid = new LineGrid(strokes, reaches)
  visitTexelsNearLines(
    texels,
    grid,
    (texel, x, y, z, normal) => {
      const sharpest = texelSize(metric, texel) / 2
      grid.visit(x, y, z, normal[0], normal[1], normal[2], (index, distance, segment, t, side) => {
        const { depths, halfWidths, shoulder, softness } = strokes[index]
        const depth = lerp(depths[segment], depths[segment + 1], t)
        const halfWidth = lerp(halfWidths[segment], halfWidths[segment + 1], t)
        if (depth === 0) return
        const raised = lerp(shoulder[0], shoulder[1], 0.5 + 0.5 * side)
        const height = depth * profile(distance / halfWidth, raised, Math.max(softness, sharpest / halfWidth))
        if (height < 0) {
          valleys[texel] += (-height) ** JOIN
          shades[texel] = Math.max(shades[texel], (-height / halfWidth) * SHADE)
        } else banks[texel] += height ** JOIN
      })
    },
    progress,
  )
}

/** The longer side of a texel in millimetres. */
function texelSize({ uu, vv, width, height }: Metric, texel: number): number {
  return Math.sqrt(Math.max(uu[texel] / width ** 2, vv[texel] / height ** 2))
}

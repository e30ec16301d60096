import type { SkinCanvas } from '../skin/canvas.ts'
import { cornersOf } from '../skin/surface.ts'
import { positionAt } from '../skin/walk.ts'
import { layCurve, type SkinLine } from '../strokes/curve.ts'
import type { Stroke } from '../strokes/document.ts'
import type { HeightMap } from '../strokes/height.ts'
import { valleyAt } from '../strokes/profile.ts'
import { borderDistance } from './cells.ts'
import { directionsAlong, TENSOR } from './direction-field.ts'
import type { Furrows } from './read-furrows.ts'

/** Levels of the net, from its cells down: size and depth as fractions. Small furrows divide the cells of large ones. */
const LEVELS = [
  { size: 1, depth: 1 },
  { size: 0.45, depth: 0.45 },
] as const
/** Half the width of a furrow, as a fraction of its cells' size. */
const HALF_WIDTH = 0.11
const SOFTNESS = 0.5

/**
 * Draws the net of fine furrows on a skin (Bando, Kuratate and Nishita 2002, A simple method for modeling wrinkles on human skin): the borders of a
 * cellular pattern, divided by those of a finer one. Its cells are stretched along the lines of the skin near them. The pattern is one of
 * space, so that seams of the texture do not show. Furrows finer than two texels are drawn wider, and less deep.
 *
 * @param lines of the skin in millimetres; far from them, cells are as long as wide.
 */
export function furrowHeights(
  { surface, texels, metric }: Pick<SkinCanvas, 'surface' | 'texels' | 'metric'>,
  furrows: Furrows,
  lines: readonly SkinLine[] = [],
): HeightMap {
  const { width, height } = metric
  const data = new Float32Array(width * height)
  const directions = directionsAlong(surface, lines)
  const [position, weights, tensor] = [new Float64Array(3), new Float64Array(3), new Float64Array(TENSOR)]
  texels.visit((texel, triangle, a, b, c) => {
    weights.set([a, b, c])
    positionAt(position, surface, triangle, weights)
    metricAt(tensor, directions, cornersOf(surface, triangle), weights, furrows.stretch)
    const texelSize = Math.sqrt(Math.max(metric.uu[texel] / width ** 2, metric.vv[texel] / height ** 2))
    data[texel] = furrowHeight(position, tensor, furrows, texelSize)
  })
  return { width, height, data }
}

/** Adds the net of fine furrows to the relief of strokes, whose lines it follows. */
export function addFurrows(
  relief: HeightMap,
  canvas: SkinCanvas,
  furrows: Furrows,
  strokes: readonly Stroke[],
): void {
  const { data } = furrowHeights(
    canvas,
    furrows,
    strokes.flatMap((stroke) => layCurve(stroke, canvas)),
  )
  for (let i = 0; i < data.length; i++) relief.data[i] += data[i]
}

/** The height of all levels at a position. */
function furrowHeight(
  [x, y, z]: Float64Array,
  metric: Float64Array,
  { size, depth, stretch, seed }: Furrows,
  texelSize: number,
): number {
  let deepest = 0
  for (const [level, { size: part, depth: fraction }] of LEVELS.entries()) {
    const cell = part * size
    const halfWidth = HALF_WIDTH * cell
    // A furrow that texels cannot resolve keeps its volume.
    const drawn = Math.max(halfWidth, texelSize)
    const distance = borderDistance(x, y, z, cell, seed + level, metric, 1 / stretch ** 2)
    deepest = Math.max(deepest, ((fraction * halfWidth) / drawn) * valleyAt(distance / drawn, SOFTNESS))
  }
  return -depth * deepest
}

/** The identity, less what counts along the direction of the skin's lines. Beyond an island it stays that of the edge. */
function metricAt(
  out: Float64Array,
  directions: Float64Array,
  corners: readonly number[],
  weights: Float64Array,
  stretch: number,
): void {
  const less = 1 - 1 / stretch ** 2
  const inside = weights.map((weight) => Math.max(0, weight))
  const total = inside[0] + inside[1] + inside[2]
  for (let k = 0; k < TENSOR; k++) {
    let along = 0
    for (let n = 0; n < 3; n++) along += (inside[n] / total) * directions[TENSOR * corners[n] + k]
    out[k] = (k < 3 ? 1 : 0) - less * along
  }
}

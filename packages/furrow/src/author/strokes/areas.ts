import { FurrowError } from '../../core/error.ts'
import type { Uv } from '../../core/json.ts'
import type { GrayImage } from '../../core/types.ts'
import { smoothstep } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { AreaShape, AreaSketch } from './area-shapes.ts'
import type { Stroke, StrokesDocument } from './document.ts'
import { nearest } from './nearest.ts'
import { layOut } from './path.ts'

/** A painted area: the part of `Area` that a document of strokes can give. */
export interface PaintedArea {
  name: string
  /** Weights, 255 = fully visible, of the metric's size. */
  weights: GrayImage
}

/** Shape of an area that its document does not describe: millimetres round the strokes of its group. */
export const GROUP_SHAPE = { radius: 7, feather: 8 } as const

/**
 * Paints the areas of a strokes document at the metric's size: those it describes, otherwise one round the
 * strokes of every group. The weight falls from 1 to 0 by smoothstep across the feather and is exactly 0 outside.
 * Throws FurrowError where the document has neither areas nor groups.
 */
export function paintAreas(document: StrokesDocument, metric: Metric): PaintedArea[] {
  const sketches = document.areas ?? groupSketches(document.strokes)
  if (sketches.length === 0) {
    throw new FurrowError({
      who: 'paintAreas',
      what: 'the document has no areas, and no stroke has a group',
      limit: 'at least one of them',
      remedy: 'give the strokes a group, or add "areas"',
    })
  }
  return sketches.map((sketch) => ({
    name: sketch.name,
    weights: paintArea(sketch, document.strokes, metric),
  }))
}

function groupSketches(strokes: readonly Stroke[]): AreaSketch[] {
  const groups = new Set(strokes.flatMap((stroke) => stroke.group ?? []))
  return [...groups].map((group) => ({ name: group, shapes: [{ group, ...GROUP_SHAPE }] }))
}

/** Paints one area: the largest of its shapes, times `within`. Strokes are needed for shapes that name a group. */
export function paintArea(sketch: AreaSketch, strokes: readonly Stroke[], metric: Metric): GrayImage {
  const { width, height } = metric
  const total = new Float32Array(width * height)
  for (const shape of sketch.shapes) {
    const weights = paintShape(shape, strokes, metric)
    for (let i = 0; i < total.length; i++) total[i] = Math.max(total[i], weights[i])
  }
  const within = sketch.within && paintShape(sketch.within, strokes, metric)
  const data = new Uint8Array(width * height)
  for (let i = 0; i < data.length; i++) data[i] = Math.round(255 * total[i] * (within ? within[i] : 1))
  return { width, height, data }
}

/** Weights 0..1 of one shape. */
function paintShape(shape: AreaShape, strokes: readonly Stroke[], metric: Metric): Float32Array {
  const weights = new Float32Array(metric.width * metric.height)
  const { feather } = shape
  if ('group' in shape) {
    for (const stroke of strokes) {
      if (stroke.group !== shape.group) continue
      nearest(layOut(stroke, metric).points, metric, shape.radius + feather / 2, (texel, distance) => {
        weights[texel] = Math.max(weights[texel], weight(distance - shape.radius, feather))
      })
    }
    return weights
  }
  for (let texel = 0; texel < weights.length; texel++) {
    if (insidePolygon(shape.polygon, metric, texel)) weights[texel] = 1
  }
  const outline = Float64Array.from([...shape.polygon, shape.polygon[0]].flat())
  nearest(outline, metric, feather / 2, (texel, distance) => {
    weights[texel] = weight(weights[texel] === 1 ? -distance : distance, feather)
  })
  return weights
}

/** 1 at half a feather inside the outline, 0.5 on it, 0 at half a feather outside; `distance` is positive outside. */
function weight(distance: number, feather: number): number {
  return 1 - smoothstep(distance / feather + 0.5)
}

/** Counts the edges to the right of the texel's centre: an odd number means inside (even-odd rule). */
function insidePolygon(polygon: Uv[], metric: Metric, texel: number): boolean {
  const u = ((texel % metric.width) + 0.5) / metric.width
  const v = (Math.floor(texel / metric.width) + 0.5) / metric.height
  let inside = false
  for (let i = 0, k = polygon.length - 1; i < polygon.length; k = i++) {
    const [a, b] = [polygon[i], polygon[k]]
    if (a[1] > v === b[1] > v) continue
    if (u < a[0] + ((v - a[1]) / (b[1] - a[1])) * (b[0] - a[0])) inside = !inside
  }
  return inside
}

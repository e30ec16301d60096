import { FurrowError } from '../../core/error.ts'
import type { GrayImage } from '../../core/types.ts'
import { isInsidePolygon } from '../../math/polygon.ts'
import { smoothstep } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { AreaDefinition, AreaShape } from './area-definitions.ts'
import type { Stroke, StrokesDocument } from './document.ts'
import { visitTexelsNear } from './near-texels.ts'
import { layOutStroke } from './path.ts'

/** A painted area: the part of `Area` that a strokes document can give. */
export interface PaintedArea {
  name: string
  /** Weights, 255 = fully visible, of the metric's size. */
  weights: GrayImage
}

/** Shape of an area that its document does not define, round the strokes of its group; millimetres. */
export const GROUP_SHAPE = { radius: 7, feather: 8 } as const

/**
 * Paints the areas of a strokes document at the metric's size: those it defines, or else one round the strokes of each
 * group. The weight falls from 1 to 0 by smoothstep across the feather and is exactly 0 outside.
 *
 * @throws FurrowError if the document has neither areas nor groups.
 */
export function paintAreas(document: StrokesDocument, metric: Metric): PaintedArea[] {
  const definitions = document.areas ?? areasOfGroups(document.strokes)
  if (definitions.length === 0) {
    throw new FurrowError({
      who: 'paintAreas',
      what: 'the document has no areas, and no stroke has a group',
      limit: 'at least one of them',
      remedy: 'give the strokes a group, or add "areas"',
    })
  }
  return definitions.map((definition) => ({
    name: definition.name,
    weights: paintArea(definition, document.strokes, metric),
  }))
}

function areasOfGroups(strokes: readonly Stroke[]): AreaDefinition[] {
  const groups = new Set(strokes.flatMap((stroke) => stroke.group ?? []))
  return [...groups].map((group) => ({ name: group, shapes: [{ group, ...GROUP_SHAPE }] }))
}

/** Paints one area: the maximum of its shapes, times `within`. Shapes of a group need its strokes. */
export function paintArea(
  { shapes, within }: AreaDefinition,
  strokes: readonly Stroke[],
  metric: Metric,
): GrayImage {
  const { width, height } = metric
  const total = new Float32Array(width * height)
  for (const shape of shapes) {
    const weights = paintShape(shape, strokes, metric)
    for (let i = 0; i < total.length; i++) total[i] = Math.max(total[i], weights[i])
  }
  const factors = within && paintShape(within, strokes, metric)
  const data = new Uint8Array(width * height)
  for (let i = 0; i < data.length; i++) data[i] = Math.round(255 * total[i] * (factors ? factors[i] : 1))
  return { width, height, data }
}

/** Weights 0..1 of one shape. */
function paintShape(shape: AreaShape, strokes: readonly Stroke[], metric: Metric): Float32Array {
  const { width, height } = metric
  const weights = new Float32Array(width * height)
  const { feather } = shape
  if ('group' in shape) {
    for (const stroke of strokes) {
      if (stroke.group !== shape.group) continue
      const { points } = layOutStroke(stroke, metric)
      visitTexelsNear(points, metric, shape.radius + feather / 2, (texel, distance) => {
        weights[texel] = Math.max(weights[texel], weightAt(distance - shape.radius, feather))
      })
    }
    return weights
  }
  for (let texel = 0; texel < weights.length; texel++) {
    const [u, v] = [((texel % width) + 0.5) / width, (Math.floor(texel / width) + 0.5) / height]
    if (isInsidePolygon(shape.polygon, u, v)) weights[texel] = 1
  }
  const outline = Float64Array.from([...shape.polygon, shape.polygon[0]].flat())
  visitTexelsNear(outline, metric, feather / 2, (texel, distance) => {
    weights[texel] = weightAt(weights[texel] === 1 ? -distance : distance, feather)
  })
  return weights
}

/**
 * 1 half a feather inside the outline, 0.5 on it, 0 half a feather outside.
 *
 * @param distance from the outline in millimetres, positive outside.
 */
function weightAt(distance: number, feather: number): number {
  return 1 - smoothstep(distance / feather + 0.5)
}

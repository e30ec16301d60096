import { FurrowError } from '../../core/error.ts'
import type { GrayImage } from '../../core/types.ts'
import { isInsidePolygon } from '../../math/polygon.ts'
import { smoothstep } from '../../math/scalar.ts'
import type { Metric } from '../metric.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import type { AreaDefinition, AreaShape, GroupShape, PolygonShape } from './area-definitions.ts'
import type { Stroke, StrokesDocument } from './document.ts'
import { isBulge, layOutStrokes } from './lay-out.ts'
import { LineGrid } from './line-grid.ts'
import { visitTexelsNear } from './near-outline.ts'

/** Area of influence: a map of weights that tells where a group of wrinkles appears. */
export interface PaintedArea {
  name: string
  /** Weights, 255 = fully visible. The image has the size of the canvas. */
  weights: GrayImage
}

/** Default area around a group's strokes: minimum radius, and width of the soft edge, in millimetres. */
const GROUP_SHAPE = { radius: 7, feather: 8 } as const

/**
 * Paints the areas of a strokes document at the canvas's size. If the document defines no areas, paints one area around the strokes of each
 * group. Weights fall from 1 to 0 by smoothstep across the soft edge (`feather`) and are exactly 0 outside.
 *
 * @throws FurrowError if the document has neither areas nor groups.
 */
export function paintAreas(document: StrokesDocument, canvas: SkinCanvas): PaintedArea[] {
  const definitions = definitionsOf(document)
  if (definitions.length === 0) {
    throw new FurrowError({
      who: 'paintAreas',
      problem: 'the document has no areas, and no stroke has a group',
      limit: 'at least one of them',
      remedy: 'give the strokes a group, or add "areas"',
    })
  }
  return definitions.map((definition) => ({
    name: definition.name,
    weights: paintArea(definition, document.strokes, canvas),
  }))
}

export function paintedNames(document: StrokesDocument): string[] {
  return definitionsOf(document).map(({ name }) => name)
}

function definitionsOf({ areas, strokes }: StrokesDocument): AreaDefinition[] {
  return areas ?? areasOfGroups(strokes)
}

function areasOfGroups(strokes: readonly Stroke[]): AreaDefinition[] {
  const groups = new Set(strokes.flatMap((stroke) => stroke.group ?? []))
  return [...groups].map((group) => ({
    name: group,
    shapes: [
      groupShape(
        group,
        strokes.filter((stroke) => stroke.group === group),
      ),
    ],
  }))
}

/**
 * Returns the default shape around the strokes of a group. A wide bulge enlarges the radius, so that the weight is 1 up to half a width from
 * the crest.
 */
export function groupShape(group: string, strokes: readonly Stroke[]): GroupShape {
  const { radius, feather } = GROUP_SHAPE
  const radii = strokes.filter(isBulge).map(({ width }) => (width + feather) / 2)
  return { group, radius: Math.max(radius, ...radii), feather }
}

/** Paints one area. `strokes` must contain the strokes of the groups that the definition names. */
export function paintArea(
  { shapes, within }: AreaDefinition,
  strokes: readonly Stroke[],
  canvas: SkinCanvas,
): GrayImage {
  const { width, height } = canvas.metric
  const total = new Float32Array(width * height)
  for (const shape of shapes) {
    const weights = paintShape(shape, strokes, canvas)
    for (let i = 0; i < total.length; i++) total[i] = Math.max(total[i], weights[i])
  }
  const factors = within && paintShape(within, strokes, canvas)
  const data = new Uint8Array(width * height)
  for (let i = 0; i < data.length; i++) data[i] = Math.round(255 * total[i] * (factors ? factors[i] : 1))
  return { width, height, data }
}

/** Returns the weights of one shape, 0..1. */
function paintShape(shape: AreaShape, strokes: readonly Stroke[], canvas: SkinCanvas): Float32Array {
  return 'group' in shape ? paintGroup(shape, strokes, canvas) : paintPolygon(shape, canvas.metric)
}

function paintGroup(
  { group, radius, feather }: GroupShape,
  strokes: readonly Stroke[],
  canvas: SkinCanvas,
): Float32Array {
  const { width, height } = canvas.metric
  const weights = new Float32Array(width * height)
  const members = strokes.filter((stroke) => stroke.group === group)
  const lines = layOutStrokes(members, canvas).flat()
  const grid = new LineGrid(
    lines,
    lines.map(() => radius + feather / 2),
  )
  canvas.texels.visitNear(grid.isNear, (texel, position, normal) => {
    grid.visit(position, normal, (_, distance) => {
      weights[texel] = Math.max(weights[texel], weightAt(distance - radius, feather))
    })
  })
  return weights
}

/** Paints a polygon in UV space. The polygon may extend beyond the skin. */
function paintPolygon({ polygon, feather }: PolygonShape, metric: Metric): Float32Array {
  const { width, height } = metric
  const weights = new Float32Array(width * height)
  for (let texel = 0; texel < weights.length; texel++) {
    const [u, v] = [((texel % width) + 0.5) / width, (Math.floor(texel / width) + 0.5) / height]
    if (isInsidePolygon(polygon, u, v)) weights[texel] = 1
  }
  const outline = Float64Array.from([...polygon, polygon[0]].flat())
  visitTexelsNear(outline, metric, feather / 2, (texel, distance) => {
    weights[texel] = weightAt(weights[texel] === 1 ? -distance : distance, feather)
  })
  return weights
}

/**
 * Returns the weight at a distance from an outline: 1 at `feather / 2` inside, 0.5 on the outline, 0 at `feather / 2` outside.
 *
 * @param distance signed distance from the outline in millimetres, positive outside.
 */
function weightAt(distance: number, feather: number): number {
  return 1 - smoothstep(distance / feather + 0.5)
}

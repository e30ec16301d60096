import type { GrayImage } from 'furrow'
import type { SkinCanvas, Uv } from 'furrow/author'
import { GROUP_SHAPE, paintArea as paintWeights } from 'furrow/internal'
import { addArea, paintArea } from '../document/areas.ts'
import type { LayerStroke, StudioArea, StudioDocument } from '../document/document.ts'
import { freeName } from '../document/names.ts'
import { addStroke, edited } from '../document/strokes.ts'

/** Name of areas added for lines without one. */
const NEW_AREA = 'lines'
/** Minimum mean weight, 0..255, for a line to lie on an area. */
const UNDER = 32

/** New line. Group and layer default to the values of the area below the line. */
export type NewLine = Omit<LayerStroke, 'layer'> & { readonly layer?: string }

/** Adds a line and extends or adds the area that shows it. */
export function addLine(document: StudioDocument, line: NewLine, canvas: SkinCanvas): StudioDocument {
  const group = line.group ?? groupUnder(document, line.points) ?? freeName(document.areas, NEW_AREA)
  const layer = line.layer ?? areasOf(document, group)[0]?.layer ?? document.layers[0].name
  const stroke = edited({ ...line, group, layer })
  return coverLine(addStroke(document, stroke), stroke, canvas)
}

/** Extends the area of a line's group to cover the line, or adds the area. */
export function coverLine(document: StudioDocument, stroke: LayerStroke, canvas: SkinCanvas): StudioDocument {
  const { group, layer } = stroke
  if (group === undefined) return document
  const [area] = areasOf(document, group)
  // A line can span a left and a right area; neither is extended.
  if (area && area.name !== group) return document
  const weights = paintWeights({ name: group, shapes: [{ group, ...GROUP_SHAPE }] }, [stroke], canvas)
  // A new area has no driver yet, so it is active at rest.
  if (!area) return addArea(document, { name: group, layer, combine: 'sum', activation: 1, weights })
  const joined = maximum(area.weights, weights)
  return joined === area.weights ? document : paintArea(document, group, joined)
}

/** Whether the area of a line covers a point. Always true for lines without an area of their own. */
export function isShownAt({ areas }: StudioDocument, { group }: LayerStroke, point: Uv): boolean {
  const area = areas.find(({ name }) => name === group)
  return !area || meanWeight(area.weights, [point]) >= UNDER
}

/** Returns the area with the group's name, or else its left and right areas. */
function areasOf({ areas }: StudioDocument, group: string): StudioArea[] {
  const own = areas.filter(({ name }) => name === group)
  return own.length > 0 ? own : areas.filter(({ name }) => removeSide(name) === group)
}

/** Returns the group of the area with the greatest weight below the points, without its side if the points span both sides. */
function groupUnder({ areas }: StudioDocument, points: readonly Uv[]): string | undefined {
  const under = areas
    .map(({ name, weights }) => ({ name, mean: meanWeight(weights, points) }))
    .filter(({ mean }) => mean >= UNDER)
    .sort((a, b) => b.mean - a.mean)
  const [best] = under
  if (!best) return undefined
  const sides = under.filter(({ name }) => name !== best.name && removeSide(name) === removeSide(best.name))
  return sides.length > 0 ? removeSide(best.name) : best.name
}

function removeSide(name: string): string {
  return name.replace(/(Left|Right)$/, '')
}

function meanWeight({ width, height, data }: GrayImage, points: readonly Uv[]): number {
  const texel = (at: number, side: number) => Math.min(side - 1, Math.floor(at * side))
  const sum = points.reduce((total, [u, v]) => total + data[texel(v, height) * width + texel(u, width)], 0)
  return sum / points.length
}

/** Returns the maximum per texel, or the first image if it is greater everywhere. */
function maximum(image: GrayImage, other: GrayImage): GrayImage {
  if (image.data.every((weight, i) => weight >= other.data[i])) return image
  return { ...image, data: image.data.map((weight, i) => Math.max(weight, other.data[i])) }
}

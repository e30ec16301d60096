import type { GrayImage } from 'furrow'
import type { SkinCanvas, Uv } from 'furrow/author'
import { groupShape, paintArea as paintWeights, texelAt } from 'furrow/internal'
import { isBloodArea } from '../document/area-at.ts'
import { addArea, paintArea } from '../document/areas.ts'
import type { LayerStroke, StudioArea, StudioDocument } from '../document/document.ts'
import { freeName } from '../document/names.ts'
import { addStroke, edited } from '../document/strokes.ts'

/** Name of the area that is added for a new line outside all areas. */
const NEW_AREA = 'lines'
/** A line is on an area if the area's mean weight at the line's points is at least this, 0..255. */
const UNDER = 32
/** A new line belongs to an area if this mean weight is at least so high. At its soft border, the line gets an area of its own. */
const OWNED = 96

/** New wrinkle line. Default group: the area that covers the line, or a new area. Default layer: the layer of this area. */
export type NewLine = Omit<LayerStroke, 'layer'> & { readonly layer?: string }

/** Adds a wrinkle line to a document. Extends the area of influence that shows the line, or adds an area. */
export function addLine(document: StudioDocument, line: NewLine, canvas: SkinCanvas): StudioDocument {
  const group = line.group ?? groupUnder(document, line.points) ?? freeName(document.areas, NEW_AREA)
  const layer = line.layer ?? areasOf(document, group)[0]?.layer ?? document.layers[0].name
  const stroke = edited({ ...line, group, layer })
  return coverLine(addStroke(document, stroke), stroke, canvas)
}

/** Extends the area that has the name of a line's group, so that it covers the line. Adds the area if it does not exist. */
export function coverLine(document: StudioDocument, stroke: LayerStroke, canvas: SkinCanvas): StudioDocument {
  const { group, layer } = stroke
  if (group === undefined) return document
  const [area] = areasOf(document, group)
  // The group has an area for a single side, such as `browLeft`. A line that crosses the middle would extend it to the other side.
  if (area && area.name !== group) return document
  const weights = paintWeights({ name: group, shapes: [groupShape(group, [stroke])] }, [stroke], canvas)
  // No driver activates a new area yet, so activate it at rest.
  if (!area) return addArea(document, { name: group, layer, combine: 'sum', activation: 1, weights })
  const joined = maximum(area.weights, weights)
  return joined === area.weights ? document : paintArea(document, group, joined)
}

/** Whether the area of a line covers a point. Returns true if no area has the name of the line's group. */
function isShownAt({ areas }: StudioDocument, { group }: LayerStroke, point: Uv): boolean {
  const area = areas.find(({ name }) => name === group)
  return !area || meanWeight(area.weights, [point]) >= UNDER
}

/**
 * Extends the area of a line to its moved points. Does nothing if the line was partly outside its area before, unless the handle is now outside.
 *
 * @param before the line before the move.
 * @param handle UV coordinates of the moved handle, if the line has a point there.
 */
export function coverMoved(
  document: StudioDocument,
  stroke: LayerStroke,
  before: LayerStroke,
  handle: Uv | null,
  canvas: SkinCanvas,
): StudioDocument {
  const isShown = ({ points }: LayerStroke) => points.every((uv) => isShownAt(document, stroke, uv))
  const isHandleOut = handle !== null && !isShownAt(document, stroke, handle)
  return isHandleOut || (isShown(before) && !isShown(stroke)) ? coverLine(document, stroke, canvas) : document
}

/** Returns the area with the name of a group. Otherwise, returns the group's areas for each side, such as `browLeft`. */
function areasOf({ areas }: StudioDocument, group: string): StudioArea[] {
  const own = areas.filter(({ name }) => name === group)
  return own.length > 0 ? own : areas.filter(({ name }) => removeSide(name) === group)
}

/**
 * Returns the name of the area of wrinkles with the greatest mean weight at the points of a line. If the line is also on the area of the other side,
 * returns the name without its side.
 */
function groupUnder({ areas }: StudioDocument, points: readonly Uv[]): string | undefined {
  const under = areas
    .filter((area) => !isBloodArea(area))
    .map(({ name, weights }) => ({ name, mean: meanWeight(weights, points) }))
    .filter(({ mean }) => mean >= OWNED)
    .sort((a, b) => b.mean - a.mean)
  const [best] = under
  if (!best) return undefined
  const sides = under.filter(({ name }) => name !== best.name && removeSide(name) === removeSide(best.name))
  return sides.length > 0 ? removeSide(best.name) : best.name
}

function removeSide(name: string): string {
  return name.replace(/(Left|Right)$/, '')
}

function meanWeight(weights: GrayImage, points: readonly Uv[]): number {
  return points.reduce((sum, uv) => sum + texelAt(weights, uv), 0) / points.length
}

/** Returns the maximum of two images at each texel. Returns `image` itself if `other` is nowhere greater. */
function maximum(image: GrayImage, other: GrayImage): GrayImage {
  if (image.data.every((weight, i) => weight >= other.data[i])) return image
  return { ...image, data: image.data.map((weight, i) => Math.max(weight, other.data[i])) }
}

import type { GrayImage } from 'furrow'
import type { SkinCanvas, Uv } from 'furrow/author'
import { GROUP_SHAPE, paintArea as paintWeights } from 'furrow/internal'
import { addArea, paintArea } from '../document/areas.ts'
import type { LayerStroke, StudioArea, StudioDocument } from '../document/document.ts'
import { freeName } from '../document/names.ts'
import { addStroke, edited } from '../document/strokes.ts'

/** Name of the areas that are made for lines where there is none. */
const NEW_AREA = 'lines'
/** Mean weight, 0..255, from which an area is under a line. */
const UNDER = 32

/** A line that may not know yet which area shows it: its group and layer are then those of the area under it. */
export type NewLine = Omit<LayerStroke, 'layer'> & { readonly layer?: string }

/** Adds a line, and makes sure that an area shows it. */
export function addLine(document: StudioDocument, line: NewLine, canvas: SkinCanvas): StudioDocument {
  const group = line.group ?? groupUnder(document, line.points) ?? freeName(document.areas, NEW_AREA)
  const layer = line.layer ?? areasOf(document, group)[0]?.layer ?? document.layers[0].name
  const stroke = edited({ ...line, group, layer })
  return withArea(addStroke(document, stroke), stroke, canvas)
}

/** Makes sure that the area of a line's group shows it: lays it round the line, and adds it where there is none. */
export function withArea(document: StudioDocument, stroke: LayerStroke, canvas: SkinCanvas): StudioDocument {
  const { group, layer } = stroke
  if (group === undefined) return document
  const [area] = areasOf(document, group)
  // Of an area for each side, none shows the line alone.
  if (area && area.name !== group) return document
  const weights = paintWeights({ name: group, shapes: [{ group, ...GROUP_SHAPE }] }, [stroke], canvas)
  // No blendshape moves a new area: it is shown until its slider or a driver says otherwise.
  if (!area) return addArea(document, { name: group, layer, combine: 'sum', activation: 1, weights })
  const joined = greater(area.weights, weights)
  return joined === area.weights ? document : paintArea(document, group, joined)
}

/** Whether the area that shows a line shows it at a point too; true where none is made for the line alone. */
export function isShownAt({ areas }: StudioDocument, { group }: LayerStroke, point: Uv): boolean {
  const area = areas.find(({ name }) => name === group)
  return !area || meanWeight(area.weights, [point]) >= UNDER
}

/** The areas that show a group: that of its name, or else those of its left and right side. */
function areasOf({ areas }: StudioDocument, group: string): StudioArea[] {
  const own = areas.filter(({ name }) => name === group)
  return own.length > 0 ? own : areas.filter(({ name }) => withoutSide(name) === group)
}

/** The group that lines here belong to: of the area with the greatest weight, of both sides where a line crosses the middle. */
function groupUnder({ areas }: StudioDocument, points: readonly Uv[]): string | undefined {
  const under = areas
    .map(({ name, weights }) => ({ name, mean: meanWeight(weights, points) }))
    .filter(({ mean }) => mean >= UNDER)
    .sort((a, b) => b.mean - a.mean)
  const [best] = under
  if (!best) return undefined
  const sides = under.filter(({ name }) => name !== best.name && withoutSide(name) === withoutSide(best.name))
  return sides.length > 0 ? withoutSide(best.name) : best.name
}

function withoutSide(name: string): string {
  return name.replace(/(Left|Right)$/, '')
}

function meanWeight({ width, height, data }: GrayImage, points: readonly Uv[]): number {
  const texel = (at: number, side: number) => Math.min(side - 1, Math.floor(at * side))
  const sum = points.reduce((total, [u, v]) => total + data[texel(v, height) * width + texel(u, width)], 0)
  return sum / points.length
}

/** The greater of two weights in each texel; the first image where it is greater everywhere. */
function greater(image: GrayImage, other: GrayImage): GrayImage {
  if (image.data.every((weight, i) => weight >= other.data[i])) return image
  return { ...image, data: image.data.map((weight, i) => Math.max(weight, other.data[i])) }
}

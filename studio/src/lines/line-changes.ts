import { insertPoint, splitStroke } from 'furrow/author'
import { mirrorStroke, splineOf } from 'furrow/internal'
import type { LayerStroke, StudioDocument } from '../document/document.ts'
import { removeStroke } from '../document/strokes.ts'
import { counterpartOf } from './counterpart.ts'
import type { Handle } from './handles.ts'
import { addLine, type NewLine } from './line-area.ts'
import type { LineSurface } from './line-surface.ts'

/** Adds a line and its mirror image. Adds no image of a line across the middle of the face, which is its own counterpart. */
export function addWithImage(document: StudioDocument, line: NewLine, surface: LineSurface): StudioDocument {
  const drawn = addLine(document, line, surface.canvas)
  const image = mirrorStroke(line, surface.canvas, surface.middle)
  const strokes = [...drawn.strokes, { ...drawn.strokes.at(-1)!, ...image }] as LayerStroke[]
  const isOwn = counterpartOf(strokes, drawn.strokes.length - 1, surface) < 0
  return isOwn ? drawn : addLine(drawn, image, surface.canvas)
}

/** Splits a line at a handle, or in the middle if there is none. Returns both parts. */
export function splitAt(
  stroke: LayerStroke,
  handle: Handle | undefined,
  { canvas, lines }: LineSurface,
): readonly LayerStroke[] {
  const { knot = -1, place = 0, fork } = handle ?? {}
  const spline = splineOf(stroke, canvas)
  if (knot > 0 && knot < spline.points.length - 1) return splitStroke(spline, knot, canvas)
  const { lengths } = lines.lineOf(stroke)!
  const along = fork && knot < 0 ? lengths[place] / lengths[lengths.length - 1] : 0.5
  const added = insertPoint(spline, along, canvas)
  const at = added.index > 0 ? added.index : Math.floor(spline.points.length / 2)
  return splitStroke(added.stroke, at, canvas)
}

/** Removes lines, given by their indices. */
export function removeLines(document: StudioDocument, indices: readonly number[]): StudioDocument {
  const last = indices.toSorted((a, b) => b - a)
  // Removing a stroke can replace the objects of other strokes, but not their order.
  return last.reduce((left, index) => removeStroke(left, left.strokes[index]), document)
}

import type { LayerStroke, StudioArea, StudioDocument } from './document.ts'
import { changed, findNamed } from './names.ts'

/** Adds a stroke at the end. Throws FurrowError when its layer is unknown. */
export function addStroke(document: StudioDocument, stroke: LayerStroke): StudioDocument {
  findNamed(document.layers, stroke.layer, 'layer')
  return { ...document, strokes: [...document.strokes, stroke] }
}

/** Replaces a stroke by a list of strokes. A list of two splits it. */
export function replaceStroke(
  document: StudioDocument,
  stroke: LayerStroke,
  others: readonly LayerStroke[],
): StudioDocument {
  const replaced = others.map(edited)
  return { ...document, strokes: document.strokes.flatMap((each) => (each === stroke ? replaced : [each])) }
}

/**
 * Removes a stroke, and marks the other strokes of its group as edited. If there are none, marks its area. Otherwise, new automatic wrinkles
 * would bring the stroke back.
 */
export function removeStroke(document: StudioDocument, stroke: LayerStroke): StudioDocument {
  const isSibling = ({ group }: LayerStroke) => group !== undefined && group === stroke.group
  const others = document.strokes.filter((each) => each !== stroke)
  const strokes = others.map((each) => (isSibling(each) ? edited(each) : each))
  if (others.some(isSibling)) return { ...document, strokes }
  const mark = (area: StudioArea): StudioArea => {
    const { isAutomatic, ...own } = area
    return isAutomatic && area.name === stroke.group ? own : area
  }
  return { ...document, strokes, areas: changed(document.areas, mark) }
}

/** Replaces strokes. @param replaced new strokes; the keys are indices. */
export function replaceStrokes(
  document: StudioDocument,
  replaced: ReadonlyMap<number, LayerStroke>,
): StudioDocument {
  if (replaced.size === 0) return document
  return {
    ...document,
    strokes: document.strokes.map((each, i) => (replaced.has(i) ? edited(replaced.get(i)!) : each)),
  }
}

/** Marks a stroke as edited by the artist. */
export function edited({ isAutomatic: _, ...stroke }: LayerStroke): LayerStroke {
  return stroke
}

export function strokesOf({ strokes }: StudioDocument, layer: string): LayerStroke[] {
  return strokes.filter((stroke) => stroke.layer === layer)
}

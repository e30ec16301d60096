import type { LayerStroke, StudioDocument } from './document.ts'
import { findNamed } from './names.ts'

/** Adds a stroke at the end. Throws FurrowError when its layer is unknown. */
export function addStroke(document: StudioDocument, stroke: LayerStroke): StudioDocument {
  findNamed(document.layers, stroke.layer, 'layer')
  return { ...document, strokes: [...document.strokes, stroke] }
}

/** Replaces a stroke: no strokes remove it, two split it. */
export function replaceStroke(
  document: StudioDocument,
  stroke: LayerStroke,
  others: readonly LayerStroke[],
): StudioDocument {
  const replaced = others.map(edited)
  return { ...document, strokes: document.strokes.flatMap((each) => (each === stroke ? replaced : [each])) }
}

/** Marks a stroke as hand-edited. */
export function edited({ isAutomatic: _, ...stroke }: LayerStroke): LayerStroke {
  return stroke
}

/** Returns the strokes of a layer, in order. */
export function strokesOf({ strokes }: StudioDocument, layer: string): LayerStroke[] {
  return strokes.filter((stroke) => stroke.layer === layer)
}

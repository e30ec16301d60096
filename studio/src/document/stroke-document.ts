import type { StrokesDocument } from 'furrow/author'
import { isFileName } from 'furrow/internal'
import type { StudioDocument } from './document.ts'

/**
 * Returns the contents of `strokes.json` for a document, or undefined if the document has no strokes. Omits the shapes of an area if the
 * area's name is not valid as a file name, or if a shape refers to a group without strokes.
 */
export function strokesDocument(document: StudioDocument): StrokesDocument | undefined {
  if (document.strokes.length === 0) return undefined
  const groups = new Set(document.strokes.map(({ group }) => group))
  const areas = document.strokeAreas?.filter(({ name, shapes, within }) => {
    const all = within ? [...shapes, within] : shapes
    return isFileName(name) && all.every((shape) => !('group' in shape) || groups.has(shape.group))
  })
  return {
    version: 1,
    scale: document.scale,
    size: document.mapSize,
    ...(document.auto?.seed !== undefined && { seed: document.auto.seed }),
    strokes: document.strokes.map(({ isAutomatic, ...stroke }) => stroke),
    ...(document.furrows && { furrows: document.furrows }),
    ...(areas && areas.length > 0 && { areas }),
  }
}

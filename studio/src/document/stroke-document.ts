import type { StrokesDocument } from 'furrow/author'
import { isFileName } from 'furrow/internal'
import type { StudioDocument } from './document.ts'

/**
 * The strokes of a document as `strokes.json` has them; undefined where there are none. Shapes that it could not have are left out: names no file
 * can have, no strokes.
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
    strokes: document.strokes.map(({ isAutomatic, ...stroke }) => stroke),
    ...(document.furrows && { furrows: document.furrows }),
    ...(areas && areas.length > 0 && { areas }),
  }
}

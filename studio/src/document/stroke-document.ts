import type { StrokesDocument } from 'furrow/author'
import { isFileName } from 'furrow/internal'
import type { StudioDocument } from './document.ts'

/**
 * Returns the strokes as stored in `strokes.json`, or undefined if there are none. Omits shapes that the file cannot hold: area names
 * that are invalid file names, and groups without strokes.
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

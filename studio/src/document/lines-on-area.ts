import type { Uv } from 'furrow/author'
import { texelAt } from 'furrow/internal'
import type { StudioArea, StudioDocument } from './document.ts'

/** Minimum weight of an area at a point that is on it, 0..255. */
export const ON_AREA = 32

/** Whether a line of the area's layer lies on the area. */
export function hasLines({ strokes }: StudioDocument, { layer, weights }: StudioArea): boolean {
  const isOn = (uv: Uv) => texelAt(weights, uv) >= ON_AREA
  return strokes.some((stroke) => stroke.layer === layer && stroke.points.some(isOn))
}

import type { Uv } from 'furrow/author'
import { areaAt, isBloodArea } from './area-at.ts'
import { emptyArea } from './areas.ts'
import type { StudioArea, StudioDocument } from './document.ts'
import { freeName } from './names.ts'

/** Name of the area that is added for skin painted outside all areas. */
const PAINTED = 'painted'

/**
 * Returns the area that a stroke paints: the chosen one, the one under the start of the stroke, or a new one. No driver activates a new area yet,
 * so it is always visible.
 *
 * @param uv start of the stroke. Undefined: not on an area.
 */
export function paintedArea(
  document: StudioDocument,
  chosen: StudioArea | null,
  uv: Uv | undefined,
): StudioArea {
  if (chosen) return chosen
  const wrinkled = document.areas.filter((area) => !isBloodArea(area))
  const under = uv && areaAt(wrinkled, uv)
  const found = wrinkled.find(({ name }) => name === under)
  return found ?? { ...emptyArea(document, freeName(document.areas, PAINTED)), activation: 1 }
}

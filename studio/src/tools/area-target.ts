import type { StudioArea } from '../document/document.ts'
import type { PaintTarget } from './paint-tool.ts'

/** Weights of an area that a stroke or a polygon paints. */
export interface AreaTarget extends PaintTarget {
  /** Area as it was before. */
  readonly area: StudioArea
  /** Whether the document did not have the area before. */
  readonly isNew: boolean
}

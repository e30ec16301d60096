import type { SkinCanvas } from 'furrow/author'
import type { MirrorPlane, StrokeLines } from 'furrow/internal'

/** Skin on which lines are edited. `middle` is the plane between its left and right half. */
export interface LineSurface {
  readonly canvas: SkinCanvas
  readonly lines: StrokeLines
  readonly middle: MirrorPlane | undefined
}

import { HEIGHT_STEPS_PER_MM, MAX_SCULPTED } from 'furrow/internal'
import { BRUSH_DEFAULTS, type DabShape, type SculptBrush, type SculptMode } from '../paint/brush.ts'
import type { Stamp } from '../paint/stamp.ts'

/** Settings of the brush that sculpts, as the user sees them. */
export interface SculptSettings extends Pick<DabShape, 'radius' | 'softness' | 'mirror'> {
  readonly mode: SculptMode
  /** Height that one stroke adds or removes at most, in the modes `raise` and `lower`, millimetres. */
  readonly height: number
  /** Strength of the modes `smooth` and `flatten`, above 0, up to 1. */
  readonly strength: number
  /** Image that shapes each dab, with its file name. */
  readonly stamp: { readonly name: string; readonly image: Stamp } | null
}

export const SCULPT_DEFAULTS: SculptSettings = {
  mode: 'raise',
  radius: 5,
  softness: 1,
  mirror: false,
  height: 0.5,
  strength: 0.5,
  stamp: null,
}

export function brushOf({ mode, height, strength, stamp, ...shape }: SculptSettings): SculptBrush {
  const isMoving = mode === 'raise' || mode === 'lower'
  return {
    ...shape,
    mode,
    rise: height * HEIGHT_STEPS_PER_MM,
    limit: MAX_SCULPTED * HEIGHT_STEPS_PER_MM,
    opacity: isMoving ? 1 : strength,
    // Dabs with a stamp do not overlap, so each one has its full effect.
    flow: stamp ? 1 : BRUSH_DEFAULTS.flow,
    ...(stamp && { stamp: stamp.image }),
  }
}

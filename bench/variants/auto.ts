import { applyFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's mode `auto`: a composed map in the default mode's shader while nothing moves; while something does, it is that mode. */
export const variant: Variant = {
  canShow: ({ still }) => still,
  warmUp: 40,
  apply: (mesh, set, renderer) => applyFurrow(mesh, set, renderer, { mode: 'auto' }),
}

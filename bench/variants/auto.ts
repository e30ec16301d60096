import { applyFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's mode `auto`: the default one, and a composed map while it is still. */
export const variant: Variant = {
  canShow: () => true,
  warmUp: 40,
  apply: (mesh, set, renderer) => applyFurrow(mesh, set, renderer, { mode: 'auto' }),
}

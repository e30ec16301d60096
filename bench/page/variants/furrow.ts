import { applyAlone } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's default mode: an influence map, lit once. */
export const variant: Variant = {
  canShow: () => true,
  apply: (mesh, set, renderer) => applyAlone(mesh, set, renderer, { mode: 'default' }),
}

import { wearFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow as it is unless told otherwise: the influence map, light once. */
export const variant: Variant = {
  canShow: () => true,
  wear: (mesh, set, renderer) => wearFurrow(mesh, set, renderer, { mode: 'default' }),
}

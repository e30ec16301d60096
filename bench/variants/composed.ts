import { wearFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow with its normals written into a map, which the plain material shows. */
export const variant: Variant = {
  canShow: () => true,
  wear: (mesh, set, renderer) => wearFurrow(mesh, set, renderer, { mode: 'composed' }),
}

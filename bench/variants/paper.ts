import { wearFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** The paper's own shader: lights twice, loops over the areas in every pixel. It knows one layer. */
export const variant: Variant = {
  canShow: ({ layers }) => layers === 1,
  wear: (mesh, set, renderer) => wearFurrow(mesh, set, renderer, { mode: 'paper' }),
}

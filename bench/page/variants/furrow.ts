import { applyAlone } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's default mode: samples an influence map, mixes normals, and computes the lighting once. */
export const variant: Variant = {
  canShow: () => true,
  apply: (mesh, set, renderer) => applyAlone(mesh, set, renderer, { mode: 'default' }),
}

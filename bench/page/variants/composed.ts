import { applyAlone } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's composed mode: draws the mixed normals into a texture that replaces the normal map of the unchanged material. */
export const variant: Variant = {
  canShow: ({ maps }) => maps === 'normals',
  apply: (mesh, set, renderer) => applyAlone(mesh, set, renderer, { mode: 'composed' }),
}

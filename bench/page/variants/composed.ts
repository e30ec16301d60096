import { applyAlone } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's composed mode: draws normals into a map of the plain material. */
export const variant: Variant = {
  canShow: ({ maps }) => maps === 'normals',
  apply: (mesh, set, renderer) => applyAlone(mesh, set, renderer, { mode: 'composed' }),
}

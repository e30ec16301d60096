import { applyAlone } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** The paper's shader: lights twice, loops over the areas in every pixel, supports one layer. */
export const variant: Variant = {
  canShow: ({ layers, maps }) => layers === 1 && maps === 'normals',
  apply: (mesh, set, renderer) => applyAlone(mesh, set, renderer, { mode: 'paper' }),
}

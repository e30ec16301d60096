import { applyAlone } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/**
 * The shader of Reis, De Martino, Batagelo: "Real-time Simulation of Wrinkles", WSCG 2008. It loops over the areas in every pixel and lights twice.
 * It supports one layer.
 */
export const variant: Variant = {
  canShow: ({ layers, maps }) => layers === 1 && maps === 'normals',
  apply: (mesh, set, renderer) => applyAlone(mesh, set, renderer, { mode: 'paper' }),
}

import { applyAlone } from '../furrow.ts'
import { autoHeights } from '../heights.ts'
import type { Variant } from '../variant.ts'

/** Furrow's default mode with relief: the height map of automatic wrinkles displaces the vertices of a dense mesh. */
export const variant: Variant = {
  canShow: ({ areas, layers, maps }) => areas === 8 && layers === 1 && maps === 'normals',
  apply: (mesh, { areas, layers }, renderer) => {
    const raised = layers.map((layer) => ({ ...layer, ...autoHeights(mesh) }))
    const wrinkles = applyAlone(mesh, { areas, layers: raised }, renderer, { relief: 'on' })
    return Object.assign(wrinkles, { ready: wrinkles.reliefReady() })
  },
}

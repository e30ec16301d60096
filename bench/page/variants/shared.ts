import { type Material, Mesh } from 'three'
import { applyAlone, applyFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's default mode, with the influence maps of two faces in one texture. Only the first face is drawn. */
export const variant: Variant = {
  canShow: ({ areas, maps }) => areas === 8 && maps !== 'onset',
  sameAs: 'furrow',
  apply: (mesh, set, renderer) => {
    const wrinkles = applyAlone(mesh, set, renderer, { mode: 'default' })
    const material = (mesh.material as Material).clone()
    const other = applyFurrow(new Mesh(mesh.geometry, material), set, renderer, { mode: 'default' })
    return {
      setActivation: (area, value) => wrinkles.setActivation(area, value),
      dispose() {
        other.dispose()
        wrinkles.dispose()
        material.dispose()
      },
    }
  },
}

import type { MeshPhysicalMaterial } from 'three'
import { callBeforeRender } from '../../../packages/furrow/src/three/mesh/before-render.ts'
import { applyFurrow } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's mode `auto`: a composed map, which the material's own program draws, while nothing moves; while something does, it is the default mode. */
export const variant: Variant = {
  canShow: ({ still }) => still,
  apply(mesh, set, renderer) {
    const wrinkles = applyFurrow(mesh, set, renderer, { mode: 'auto' })
    let isComposed = false
    callBeforeRender(mesh, () => {
      isComposed = (mesh.material as MeshPhysicalMaterial).normalMap!.isRenderTargetTexture
    })
    return {
      setActivation: (area, value) => wrinkles.setActivation(area, value),
      isSettled: () => isComposed,
      dispose: () => wrinkles.dispose(),
    }
  },
}

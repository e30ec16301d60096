import type { MeshPhysicalMaterial } from 'three'
import { callBeforeRender } from '../../../packages/furrow/src/three/mesh/before-render.ts'
import { applyAlone } from '../furrow.ts'
import type { Variant } from '../variant.ts'

/** Furrow's mode `auto`: a composed map while nothing moves; while something does, that too in large pictures, in others a dual map. */
export const variant: Variant = {
  canShow: () => true,
  sameAs: 'furrow',
  apply(mesh, set, renderer, { still }) {
    const wrinkles = applyAlone(mesh, set, renderer, { mode: 'auto' })
    const { reach } = wrinkles.editable('bench').inputs
    let isSettled = false
    callBeforeRender(mesh, () => {
      const { normalMap } = mesh.material as MeshPhysicalMaterial
      // A composed map leaves nothing to mix in.
      const isMixed = reach.value.x < reach.value.z
      isSettled = normalMap!.isRenderTargetTexture && !(still && isMixed)
    })
    return {
      setActivation: (area, value) => wrinkles.setActivation(area, value),
      isSettled: () => isSettled,
      dispose: () => wrinkles.dispose(),
    }
  },
}

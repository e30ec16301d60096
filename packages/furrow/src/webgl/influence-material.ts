import { MeshBasicMaterial } from 'three'
import type { WrinkleInputs } from '../three/Wrinkles.ts'
import { influenceFragment } from './shader.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export function influenceMaterial(inputs: WrinkleInputs): MeshBasicMaterial {
  const material = new MeshBasicMaterial({ toneMapped: false })
  material.defines = { USE_UV: '' }
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, {
      furrowAreas: { value: inputs.areas },
      furrowActivations: { value: inputs.activations },
      furrowAreaCount: inputs.areaCount,
    })
    shader.fragmentShader = influenceFragment(shader.fragmentShader)
  }
  material.customProgramCacheKey = () => 'furrow influence'
  return material
}

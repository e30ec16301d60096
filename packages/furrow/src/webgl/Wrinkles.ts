import type { IUniform, Mesh, WebGLProgramParametersWithUniforms, WebGLRenderer } from 'three'
import type { WrinkleSet } from '../core/types.ts'
import { type RendererParts, WrinklesBase, type WrinklesOptions } from '../three/Wrinkles.ts'
import { influenceMaterial } from './influence-material.ts'
import { defaultFragment, paperFragment } from './shader.ts'

/** Wrinkles on one mesh for `WebGLRenderer`. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a material of its own that is lit.
   * @param set copied; later changes to it are not seen, use `addArea` and `removeArea`.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then untouched.
   */
  constructor(mesh: Mesh, set: WrinkleSet, options: WrinklesOptions = {}) {
    super({ patch, influenceMaterial }, mesh, set, options)
  }
}

/** A small patch of the material's own GLSL, chained after the user's `onBeforeCompile`, if any. */
const patch: RendererParts['patch'] = (material, inputs, mode) => {
  const { onBeforeCompile, customProgramCacheKey } = material
  const own = { onBeforeCompile, customProgramCacheKey }
  const colours: Record<string, IUniform> =
    mode === 'paper'
      ? { furrowColours: { value: inputs.colours } }
      : { furrowNormals: { value: inputs.normals } }
  const uniforms = {
    furrowAreas: { value: inputs.areas },
    furrowActivations: { value: inputs.activations },
    furrowAreaCount: inputs.areaCount,
    ...colours,
  }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    Object.assign(shader.uniforms, uniforms)
    shader.fragmentShader =
      mode === 'paper'
        ? paperFragment(shader.fragmentShader, inputs.diffuseIsSrgb)
        : defaultFragment(shader.fragmentShader, inputs.kinds)
  }
  const variant = mode === 'paper' ? `paper ${inputs.diffuseIsSrgb}` : `default ${inputs.kinds.join(' ')}`
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} furrow ${variant}`
  return () => Object.assign(material, own)
}

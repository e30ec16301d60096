import { type IUniform, MeshBasicMaterial } from 'three'
import type { RendererParts } from '../three/Wrinkles.ts'
import { areasFragment, instancedVertex, mapFragment } from './shader.ts'
import { areaUniforms, mapUniforms } from './uniforms.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export const influenceMaterial: RendererParts['influenceMaterial'] = (inputs, table, instanced) => {
  const layers = inputs.textures.layers.length
  const { channels } = inputs.areas
  const material = new MeshBasicMaterial({ toneMapped: false })
  material.defines = { USE_UV: '' }
  const uniforms: Record<string, IUniform> = table ? areaUniforms(inputs, table) : mapUniforms(inputs)
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms)
    if (!table && instanced) shader.vertexShader = instancedVertex(shader.vertexShader)
    shader.fragmentShader = table
      ? areasFragment(shader.fragmentShader, channels)
      : mapFragment(shader.fragmentShader, layers, instanced)
  }
  const variant = table ? `areas ${channels}` : `map ${layers} ${instanced}`
  material.customProgramCacheKey = () => `furrow influence ${variant}`
  return material
}

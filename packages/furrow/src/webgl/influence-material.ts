import { type IUniform, MeshBasicMaterial } from 'three'
import type { RendererParts } from '../three/Wrinkles.ts'
import { areasFragment, instancedVertex, mapFragment } from './shader.ts'
import { areaUniforms, mapUniforms } from './uniforms.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export const influenceMaterial: RendererParts['influenceMaterial'] = (
  { normalMap },
  inputs,
  table,
  instanced,
) => {
  const layers = inputs.textures.layers.length
  const { channels } = inputs.areas
  // The map lends its texture coordinates, transform included; the shader samples the areas instead.
  const material = new MeshBasicMaterial({ map: normalMap, toneMapped: false })
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

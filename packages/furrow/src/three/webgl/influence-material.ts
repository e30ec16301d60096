import { type IUniform, MeshBasicMaterial } from 'three'
import type { RendererParts } from '../material/renderer-parts.ts'
import { areasFragment, instancedVertex, mapFragment } from './shader.ts'
import { areaUniforms, mapUniforms } from './uniforms.ts'

/** Shows the influence as gray on the mesh as it moves: black = no wrinkles, white = fully visible. */
export const influenceMaterial: RendererParts['influenceMaterial'] = (
  { normalMap },
  inputs,
  table,
  instances,
) => {
  const layers = inputs.textures.layers.length
  const { channels } = inputs.areas
  // The map lends its texture coordinates, transform included; the shader samples the areas instead.
  const material = new MeshBasicMaterial({ map: normalMap, toneMapped: false })
  const uniforms: Record<string, IUniform> = table ? areaUniforms(inputs, table) : mapUniforms(inputs)
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms)
    if (!table && instances) shader.vertexShader = instancedVertex(shader.vertexShader, instances)
    shader.fragmentShader = table
      ? areasFragment(shader.fragmentShader, channels)
      : mapFragment(shader.fragmentShader, layers, instances !== null)
  }
  const variant = table ? `areas ${channels}` : `map ${layers} ${instances}`
  material.customProgramCacheKey = () => `furrow influence ${variant}`
  return material
}

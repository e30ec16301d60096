import { ShaderMaterial } from 'three'
import type { RendererParts } from '../material/renderer-parts.ts'
import { QUAD_SETTINGS } from './influence-quads.ts'
import { composedFragment } from './shader.ts'
import { layerUniforms, mapUniforms } from './uniforms.ts'

/** Draws the composed normal map on `WebGLRenderer`. */
export const composeMaterial: RendererParts['composeMaterial'] = (base, inputs) => {
  const { kinds, normals } = inputs.textures
  return new ShaderMaterial({
    ...QUAD_SETTINGS,
    name: 'furrow composed',
    fragmentShader: composedFragment({ kinds, normals: normals.slices }),
    uniforms: { ...mapUniforms(inputs), ...layerUniforms(inputs), furrowBase: { value: base } },
  })
}

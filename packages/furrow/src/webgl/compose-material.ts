import { DoubleSide, GLSL3, NoBlending, ShaderMaterial } from 'three'
import type { RendererParts } from '../three/renderer-parts.ts'
import { QUADS_VERTEX } from './influence-quads.ts'
import { composedFragment } from './shader.ts'
import { layerUniforms, mapUniforms } from './uniforms.ts'

/** Draws the composed normal map on `WebGLRenderer`. */
export const composeMaterial: RendererParts['composeMaterial'] = (base, inputs) => {
  const { kinds, normals } = inputs.textures
  const shape = { kinds, normals: normals.slices, values: {}, instances: null, anisotropic: false }
  return new ShaderMaterial({
    name: 'furrow composed',
    glslVersion: GLSL3,
    vertexShader: QUADS_VERTEX,
    fragmentShader: composedFragment(shape),
    uniforms: { ...mapUniforms(inputs), ...layerUniforms(inputs), furrowBase: { value: base } },
    blending: NoBlending,
    side: DoubleSide,
    depthTest: false,
    depthWrite: false,
  })
}

import type { IUniform } from 'three'
import type { ShaderInputs } from '../material/shader-inputs.ts'

/** Uniforms of shaders that read the influence map. */
export function mapUniforms(inputs: ShaderInputs): Record<string, IUniform> {
  return {
    furrowInfluenceMap: inputs.influence,
    furrowGrid: inputs.grid,
    furrowCell: inputs.cell,
    furrowInside: inputs.inside,
    furrowInset: inputs.inset,
    furrowBounds: inputs.reach,
    furrowFade: inputs.fade,
  }
}

/** Uniforms of shaders that mix the layers' maps. */
export function layerUniforms({
  textures,
  normalScale,
  occlusionStrength,
  bloodAmplitude,
}: ShaderInputs): Record<string, IUniform> {
  const values = Object.entries(textures.values).map(([kind, { texture }]) => [
    `furrow_${kind}`,
    { value: texture },
  ])
  return {
    furrowNormals: { value: textures.normals.texture },
    furrowNormalScale: normalScale,
    furrowOcclusionStrength: occlusionStrength,
    furrowBloodAmplitude: bloodAmplitude,
    ...Object.fromEntries(values),
  }
}

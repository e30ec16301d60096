import type { IUniform } from 'three'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import { valueLayers } from './mixing/value-layers.ts'

/** Returns the uniforms of shaders that sample the influence map. */
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

/** Returns the uniforms of shaders that mix the maps of layers into the maps of a material. */
export function layerUniforms({
  textures,
  normalScale,
  occlusionStrength,
  bloodAmplitude,
  onsetStrength,
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
    furrowOnsetStrength: onsetStrength,
    ...Object.fromEntries(values),
  }
}

/** Returns the uniforms of shaders that delay influence by onset maps, but mix no other value maps. */
export function onsetUniforms({ textures, onsetStrength }: ShaderInputs): Record<string, IUniform> {
  const { onset } = textures.values
  if (!onset) return {}
  const { sampler } = valueLayers(textures.values).onset!
  return { [`furrow_${sampler}`]: { value: onset.texture }, furrowOnsetStrength: onsetStrength }
}

/** TSL that delays the influence of layers by their onset maps. A texel of an onset map is the influence at which wrinkles begin to show. */
import { float, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { SMALLEST_ONSET_RANGE } from '../../../core/limits.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { CHANNELS, inputUniform } from '../node.ts'
import type { SampleSlice } from '../texture-sampling.ts'
import type { LayerInfluence } from './mix-normals.ts'

/** Returns a function that samples each slice of the value maps once, and returns the same texel when it is called again. */
export function texelReader({ uv, sampler, texels }: Omit<LayerInfluence, 'influence'>): SampleSlice {
  const sample = sampler(uv)
  return (texture, slice) => {
    const key = `${texture.id} ${slice}`
    const texel = texels.get(key) ?? sample(texture, slice)
    texels.set(key, texel)
    return texel
  }
}

/**
 * Delays the influence of layers by their onset maps, see `onsetInfluence` in the reference. Layers without an onset map keep their influence.
 *
 * @param influence influence of layers 0..3 in x, y, z, w, each 0..1.
 * @param read samples a slice of the onset maps.
 */
export function delayInfluence(
  { textures, onsetStrength }: ShaderInputs,
  influence: Node<'vec4'>,
  read: SampleSlice,
): Node<'vec4'> {
  const { onset } = textures.values
  if (!onset) return influence
  const strengths = inputUniform<'vec4'>(onsetStrength)
  const [x, y, z, w] = CHANNELS.map((channel, layer): Node<'float'> => {
    const slice = onset.slices[layer] ?? null
    if (slice === null) return influence[channel]
    return delayed(
      influence[channel],
      read(onset.texture, slice)[CHANNELS[onset.channel]],
      strengths[channel],
    )
  })
  return vec4(x, y, z, w).toVar()
}

function delayed(influence: Node<'float'>, onset: Node<'float'>, strength: Node<'float'>): Node<'float'> {
  const range = onset.oneMinus().max(SMALLEST_ONSET_RANGE)
  const t = float(1).sub(influence.oneMinus().div(range)).clamp(0, 1).toVar()
  return influence.add(t.mul(float(2).sub(t)).sub(influence).mul(strength))
}

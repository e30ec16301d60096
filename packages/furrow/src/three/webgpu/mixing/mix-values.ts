/**
 * Mixing of the layers' value maps into the material's own, in TSL; same formulas as the GLSL in `webgl/` and the reference. Avoids `select`,
 * which TSL compiles to a branch: the first one costs software rasterisers a tenth of the plain face.
 */
import { max, mix, step, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../../core/blood.ts'
import { TOON_LINE } from '../../../core/toon-line.ts'
import type { ArrayTexture } from '../../material/array-texture.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import type { ValueKind } from '../../material/wrinkle-textures.ts'
import { CHANNELS, inputUniform } from '../node.ts'
import { type LayerInfluence, sharesOf } from './mix-normals.ts'

/** Kinds of single-channel maps. */
type SingleKind = Exclude<ValueKind, 'baseColor'>

/** Mixes the layers' value maps into a material's own values, see `mixValues` in the reference. */
export interface ValueMixer {
  /** @param base base colour of the material's map, 1 without a map. */
  mixColour(base: Node<'vec3'>): Node<'vec3'>
  /** @param base value of the material's map, 1 without a map; 0 for blood. */
  mixValue(kind: SingleKind, base: Node<'float'>): Node<'float'>
}

/** Creates a mixer that samples each slice once, even if its channels hold several kinds. */
export function valueMixer(
  { textures, occlusionStrength, bloodAmplitude }: ShaderInputs,
  { influence, uv, sampler }: LayerInfluence,
): ValueMixer {
  const sample = sampler(uv)
  const known = new Map<string, Node<'vec4'>>()
  const read = (texture: ArrayTexture, slice: number) => {
    const key = `${texture.id} ${slice}`
    const texel = known.get(key) ?? sample(texture, slice)
    known.set(key, texel)
    return texel
  }
  const scales = {
    occlusion: inputUniform<'vec4'>(occlusionStrength),
    blood: inputUniform<'vec4'>(bloodAmplitude),
  }
  const layersOf = (kind: ValueKind) => {
    const { texture, slices, channel } = textures.values[kind]!
    const layers = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
    const shares = sharesOf(layers.map(({ layer }) => influence[CHANNELS[layer]]))
    return layers.map(({ slice, layer }, i) => {
      const texel = read(texture, slice)
      return { texel, stored: texel[CHANNELS[channel]], layer, share: shares[i] }
    })
  }
  /** Value from the stored value of a layer's map. */
  const decode = (kind: SingleKind, stored: Node<'float'>, layer: number) => {
    if (kind === 'roughness') return stored
    const scale = scales[kind][CHANNELS[layer]]
    return kind === 'blood' ? bloodOf(stored).mul(scale) : stored.sub(1).mul(scale).add(1)
  }
  return {
    mixColour: (base) =>
      layersOf('baseColor').reduce<Node<'vec3'>>(
        (mixed, { texel, share }) => mixed.add(texel.rgb.sub(base).mul(share)),
        base,
      ),
    mixValue: (kind, base) =>
      layersOf(kind).reduce<Node<'float'>>(
        (mixed, { stored, layer, share }) => mixed.add(decode(kind, stored, layer).sub(base).mul(share)),
        base,
      ),
  }
}

/** See `bloodOf` in the reference. */
export function bloodOf(stored: Node<'float'>): Node<'float'> {
  const steps = stored.mul(255).sub(BLOOD_AT_REST).toVar()
  return max(steps.div(255 - BLOOD_AT_REST), -1).mul(step(BLOOD_THRESHOLD, steps.abs()))
}

/** Skin colour with blood, see `bloodColour` in the reference. */
export function bloodColour(colour: Node<'vec3'>, blood: Node<'float'>): Node<'vec3'> {
  return colour.mul(
    vec3(...BLOOD_ABSORPTION)
      .mul(blood.negate())
      .exp(),
  )
}

/** Returns a function from a light's cosine to the factor of its highlights, see `microShadow` in the reference. */
export function microShadow(visibility: Node<'float'>): (cosine: Node<'float'>) => Node<'float'> {
  const inverse = visibility.oneMinus().max(MIN_CONE).reciprocal().toVar()
  return (cosine) => cosine.mul(cosine).mul(inverse).min(1)
}

/** Lower bound of the cone without occlusion, so that every lit cosine gives 1. */
const MIN_CONE = 1e-20

/**
 * Draws wrinkles as lines on toon materials, see `toonColour` in the reference.
 *
 * @param base unpacked normal of the material.
 * @param mixed unpacked normal with wrinkles.
 */
export function toonColour(colour: Node<'vec3'>, base: Node<'vec3'>, mixed: Node<'vec3'>): Node<'vec3'> {
  const [from, to] = TOON_LINE.slopes
  const slopeOf = (normal: Node<'vec3'>) => normal.xy.div(normal.z)
  const line = slopeOf(mixed).sub(slopeOf(base)).length().smoothstep(from, to)
  return colour.mul(mix(vec3(1), colour.mul(TOON_LINE.shade), line))
}

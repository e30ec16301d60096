/**
 * TSL that mixes the value maps of layers (base colour, roughness, occlusion, blood) into the maps of a material. The formulas are the same as
 * in the GLSL of `webgl/`, and in the reference implementation, `core/reference`. The code avoids `select`, which TSL compiles to a branch. On a
 * software rasteriser, a single branch costs a tenth of the draw time of the face without wrinkles.
 */
import { max, mix, step, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../../core/blood.ts'
import { TOON_LINE } from '../../../core/toon-line.ts'
import type { MixedKind } from '../../../runtime/maps/layer-maps.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { CHANNELS, inputUniform } from '../node.ts'
import { type LayerInfluence, sharesOf } from './mix-normals.ts'
import { texelReader } from './onset.ts'

type SingleKind = Exclude<MixedKind, 'baseColor'>

/** Mixes the value maps of layers into the values of a material, see `mixValues` in the reference. */
export interface ValueMixer {
  /** @param base base colour in the map of the material; 1 without a map. */
  mixColour(base: Node<'vec3'>): Node<'vec3'>
  /** @param base value of the material's own map, or 1 if it has none. 0 for blood, because materials have no blood map. */
  mixValue(kind: SingleKind, base: Node<'float'>): Node<'float'>
}

/** Creates a mixer that samples each slice once, even if the slice holds several kinds of maps in its channels. */
export function valueMixer(
  { textures, occlusionStrength, bloodAmplitude }: ShaderInputs,
  layerInfluence: LayerInfluence,
): ValueMixer {
  const { influence } = layerInfluence
  const read = texelReader(layerInfluence)
  const scales = {
    occlusion: inputUniform<'vec4'>(occlusionStrength),
    blood: inputUniform<'vec4'>(bloodAmplitude),
  }
  const layersOf = (kind: MixedKind) => {
    const { texture, slices, channel } = textures.values[kind]!
    const layers = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
    const shares = sharesOf(layers.map(({ layer }) => influence[CHANNELS[layer]]))
    return layers.map(({ slice, layer }, i) => {
      const texel = read(texture, slice)
      return { texel, stored: texel[CHANNELS[channel]], layer, share: shares[i] }
    })
  }
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

/** Converts the stored value of a blood map to an amount of blood, see `bloodOf` in the reference. */
export function bloodOf(stored: Node<'float'>): Node<'float'> {
  const steps = stored.mul(255).sub(BLOOD_AT_REST).toVar()
  return max(steps.div(255 - BLOOD_AT_REST), -1).mul(step(BLOOD_THRESHOLD, steps.abs()))
}

/** Returns the colour of skin with an amount of blood, see `bloodColour` in the reference. */
export function bloodColour(colour: Node<'vec3'>, blood: Node<'float'>): Node<'vec3'> {
  return colour.mul(
    vec3(...BLOOD_ABSORPTION)
      .mul(blood.negate())
      .exp(),
  )
}

/**
 * Returns a function that computes how much occlusion darkens the highlight of a light, see `microShadow` in the reference. Its parameter is
 * the cosine between normal and light direction.
 */
export function microShadow(visibility: Node<'float'>): (cosine: Node<'float'>) => Node<'float'> {
  const inverse = visibility.oneMinus().max(MIN_CONE).reciprocal().toVar()
  return (cosine) => cosine.mul(cosine).mul(inverse).min(1)
}

/** Avoids a division by 0 in `microShadow`. Without occlusion, the factor of every highlight is then 1. */
const MIN_CONE = 1e-20

/**
 * Draws wrinkles as dark lines on toon materials, see `toonColour` in the reference.
 *
 * @param base tangent-space normal of the material.
 * @param mixed tangent-space normal with wrinkles.
 */
export function toonColour(colour: Node<'vec3'>, base: Node<'vec3'>, mixed: Node<'vec3'>): Node<'vec3'> {
  const [from, to] = TOON_LINE.slopes
  const slopeOf = (normal: Node<'vec3'>) => normal.xy.div(normal.z)
  const line = slopeOf(mixed).sub(slopeOf(base)).length().smoothstep(from, to)
  return colour.mul(mix(vec3(1), colour.mul(TOON_LINE.shade), line))
}

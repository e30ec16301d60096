/**
 * The layers' other maps mixed into the material's own, in TSL; the same formulas as the GLSL of `webgl/` and the reference. No select, which TSL
 * makes a branch: software rasterisers pay a tenth of the plain face for the first one.
 */
import { Fn, float, max, mix, step, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../../core/blood.ts'
import { TOON_LINE } from '../../../core/toon-line.ts'
import type { ArrayTexture } from '../../material/array-texture.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import type { ValueKind } from '../../material/wrinkle-textures.ts'
import { CHANNELS, inputUniform } from '../node.ts'
import { type LayerInfluence, sum } from './mix-normals.ts'

/** Reads texels of a slice of an array. */
export type TexelReader = (texture: ArrayTexture, slice: number) => Node<'vec4'>

/** Reads each slice once, whatever number of kinds its channels hold, and however often they are mixed in. */
export function texelReader({ uv, sampler }: LayerInfluence): TexelReader {
  const sample = sampler(uv)
  const known = new Map<string, Node<'vec4'>>()
  return (texture, slice) => {
    const key = `${texture.id} ${slice}`
    const texel = known.get(key) ?? sample(texture, slice).toVar()
    known.set(key, texel)
    return texel
  }
}

/**
 * Mixes one kind of the layers' other maps into the material's own value, see `mixValues` in the reference.
 *
 * @param base the value of the material's own map, 1 where it has none, 0 of blood; single values in all three components.
 * @returns the mixed value; single values in x.
 */
export function mixValues(
  kind: ValueKind,
  base: Node<'vec3'>,
  { textures, occlusionStrength, bloodAmplitude }: ShaderInputs,
  influence: Node<'vec4'>,
  read: TexelReader,
): Node<'vec3'> {
  const { texture, slices, channel } = textures.values[kind]!
  const scales = inputUniform<'vec4'>(kind === 'blood' ? bloodAmplitude : occlusionStrength)
  const layers = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
  return Fn(() => {
    const own = base.toVar()
    const value = own.toVar()
    const influences = influence.toVar()
    const influenceOf = (layer: number) => influences[CHANNELS[layer]]
    const total = max(float(1), sum(layers.map(({ layer }) => influenceOf(layer)))).toVar()
    for (const { slice, layer } of layers) {
      const texel = read(texture, slice).toVar()
      const stored = kind === 'baseColor' ? texel.rgb : vec3(texel[CHANNELS[channel]])
      const sampled = decode(kind, stored, scales[CHANNELS[layer]])
      value.addAssign(sampled.sub(own).mul(influenceOf(layer).div(total)))
    }
    return value
  })()
}

/** The value of what is stored in a map, and the scale of its layer. */
function decode(kind: ValueKind, stored: Node<'vec3'>, scale: Node<'float'>): Node<'vec3'> {
  if (kind === 'occlusion') return stored.sub(1).mul(scale).add(1)
  return kind === 'blood' ? vec3(bloodOf(stored.x).mul(scale)) : stored
}

/** See `bloodOf` in the reference. */
export function bloodOf(stored: Node<'float'>): Node<'float'> {
  const steps = stored.mul(255).sub(BLOOD_AT_REST).toVar()
  return max(steps.div(255 - BLOOD_AT_REST), -1).mul(step(BLOOD_THRESHOLD, steps.abs()))
}

/** The skin's colour with its blood, see `bloodColour` in the reference. */
export function bloodColour(colour: Node<'vec3'>, blood: Node<'float'>): Node<'vec3'> {
  return colour.mul(
    vec3(...BLOOD_ABSORPTION)
      .mul(blood.negate())
      .exp(),
  )
}

/** Returns a function that gives the factor of a light's highlights by its cosine, see `microShadow` in the reference. */
export function microShadow(visibility: Node<'float'>): (cosine: Node<'float'>) => Node<'float'> {
  const inverse = visibility.oneMinus().max(LEAST_CONE).reciprocal().toVar()
  return (cosine) => cosine.mul(cosine).mul(inverse).min(1)
}

/** Where nothing is occluded, so that any cosine that lights anything gives 1. */
const LEAST_CONE = 1e-20

/**
 * Draws wrinkles as lines, for materials that light in steps, see `toonColour` in the reference.
 *
 * @param own the material's own normal, unpacked.
 * @param mixed the same with wrinkles.
 */
export function toonColour(colour: Node<'vec3'>, own: Node<'vec3'>, mixed: Node<'vec3'>): Node<'vec3'> {
  const [from, to] = TOON_LINE.slopes
  const slopeOf = (normal: Node<'vec3'>) => normal.xy.div(normal.z)
  const line = slopeOf(mixed).sub(slopeOf(own)).length().smoothstep(from, to)
  return colour.mul(mix(vec3(1), colour.mul(TOON_LINE.shade), line))
}

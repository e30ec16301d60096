/**
 * GLSL that mixes the value maps of layers (base colour, roughness, occlusion, blood) into the maps of a material, and draws wrinkles as dark
 * lines on toon materials. "The reference" is `core/reference`.
 */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../../core/blood.ts'
import { TOON_LINE } from '../../../core/toon-line.ts'
import type { MixedKind } from '../../../runtime/maps/layer-maps.ts'
import { sharesOf } from '../../../runtime/maps/layer-shares.ts'
import { listTexels, texelOf, type ValueLayers } from '../../../runtime/maps/value-texels.ts'
import type { Values } from './value-layers.ts'

/** Declares `vec3 furrowToonColour(vec3 colour, vec3 base, vec3 mixed)`, see `toonColour` in the reference. */
export const TOON_COLOUR = /* glsl */ `
vec3 furrowToonColour(vec3 colour, vec3 base, vec3 mixed) {
  float slope = length(mixed.xy / mixed.z - base.xy / base.z);
  return colour * mix(vec3(1.0), colour * ${TOON_LINE.shade}, smoothstep(${TOON_LINE.slopes.join(', ')}, slope));
}
`

/** Declares `float furrowMicroShadow(float cosine)`, see `microShadow` in the reference. Shaders must call `furrowOcclude` first. */
export const MICRO_SHADOW = /* glsl */ `
float furrowVisibility = 1.0;
highp float furrowInverseCone = 1e20;
void furrowOcclude(highp float visibility) {
  furrowVisibility = visibility;
  furrowInverseCone = 1.0 / max(1.0 - visibility, 1e-20);
}
float furrowMicroShadow(highp float cosine) {
  return min(cosine * cosine * furrowInverseCone, 1.0);
}
`

/** Declares `vec3 furrowBloodColour(vec3 colour)`, see `bloodColour` in the reference. It calls `furrowMix_blood`. */
export const BLOOD_COLOUR = /* glsl */ `
vec3 furrowBloodColour(vec3 colour) {
  float blood = furrowMix_blood(0.0);
  return colour * exp(-blood * vec3(${BLOOD_ABSORPTION.join(', ')}));
}
`

/** Declares `float furrowBloodOf(float stored)`, see `bloodOf` in the reference. */
export const BLOOD_OF = /* glsl */ `
float furrowBloodOf(float stored) {
  float steps = stored * 255.0 - ${BLOOD_AT_REST}.0;
  return max(steps / ${255 - BLOOD_AT_REST}.0, -1.0) * step(${BLOOD_THRESHOLD}, abs(steps));
}
`

/** GLSL that reads one kind of map. */
interface ValueReading {
  type: string
  /** Swizzle that selects the value from a texel. */
  swizzle: (channel: number) => string
  /** Name of the uniform with the strength of the map per layer. */
  uniform?: string
  /** Returns an expression for the value, from the stored value and the strength. */
  decode?: (stored: string, scale: string) => string
  /** Declarations of functions that `decode` calls. */
  functions?: string
}

const component = (channel: number) => `[${channel}]`

const VALUES: Record<MixedKind, ValueReading> = {
  baseColor: { type: 'vec3', swizzle: () => '.rgb' },
  roughness: { type: 'float', swizzle: component },
  occlusion: {
    type: 'float',
    swizzle: component,
    uniform: 'furrowOcclusionStrength',
    decode: (stored, strength) => `mix(1.0, ${stored}, ${strength})`,
  },
  blood: {
    type: 'float',
    swizzle: component,
    uniform: 'furrowBloodAmplitude',
    decode: (stored, amplitude) => `furrowBloodOf(${stored}) * ${amplitude}`,
    functions: BLOOD_OF,
  },
}

/**
 * Declares the samplers of the value maps, and `void furrowReadValues()`, which samples each slice once and stores the texels in globals.
 *
 * @param sample name of the function that samples a slice.
 */
export function valueReading(values: Values, sample = 'furrowSampleSlice'): string {
  const texels = listTexels(values)
  const samplers = new Set(texels.map(({ sampler }) => sampler))
  const declared = [...samplers].map((sampler) => `uniform highp sampler2DArray furrow_${sampler};`)
  const variables = texels.map(({ name }) => `vec4 ${name} = vec4(0.0);`)
  const statements = texels.map(
    ({ name, sampler, slice }) => `${name} = ${sample}(furrow_${sampler}, ${slice}.0);`,
  )
  return /* glsl */ `
${[...declared, ...variables].join('\n')}
void furrowReadValues() {
  ${statements.join('\n  ')}
}
`
}

/**
 * Declares `TYPE furrowMix_KIND(TYPE base)`, which mixes the values of layers into the value `base` of the material, see `mixValues` in the
 * reference. Shaders must call `furrowReadValues` first.
 */
export function valueMixing(kind: MixedKind, { slices, channel, sampler }: ValueLayers): string {
  const { type, swizzle, uniform, decode, functions = '' } = VALUES[kind]
  const layers = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
  const shares = sharesOf(layers.map(({ layer }) => `furrowInfluence[${layer}]`))
  const mixed = layers.map(({ slice, layer }, i) => {
    const stored = `${texelOf(sampler, slice)}${swizzle(channel)}`
    const value = decode ? decode(stored, `${uniform}[${layer}]`) : stored
    return ` + (${value} - base) * (${shares[i]})`
  })
  return /* glsl */ `
${functions}${uniform ? `uniform vec4 ${uniform};` : ''}
${type} furrowMix_${kind}(${type} base) {
  return base${mixed.join('')};
}
`
}

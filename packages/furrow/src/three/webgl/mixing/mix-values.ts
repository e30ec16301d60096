/** GLSL of the layers' value maps, and of toon lines. */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../../core/blood.ts'
import { TOON_LINE } from '../../../core/toon-line.ts'
import { sharesOf } from '../../../runtime/layer-shares.ts'
import { listTexels, texelOf, type ValueLayers } from '../../../runtime/value-texels.ts'
import type { ValueKind } from '../../material/wrinkle-textures.ts'
import type { Values } from './value-layers.ts'

/** Declares `vec3 furrowToonColour(vec3 colour, vec3 base, vec3 mixed)`, see `toonColour` in the reference. */
export const TOON_COLOUR = /* glsl */ `
vec3 furrowToonColour(vec3 colour, vec3 base, vec3 mixed) {
  float slope = length(mixed.xy / mixed.z - base.xy / base.z);
  return colour * mix(vec3(1.0), colour * ${TOON_LINE.shade}, smoothstep(${TOON_LINE.slopes.join(', ')}, slope));
}
`

/** Declares `float furrowMicroShadow(float cosine)`, see `microShadow` in the reference; call `furrowOcclude` first. */
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

/** Declares `vec3 furrowBloodColour(vec3 colour)`, see `bloodColour` in the reference; needs `furrowMix_blood`. */
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

/** GLSL that reads the values of one kind of map. */
interface ValueReading {
  type: string
  /** Swizzle of a texel. */
  swizzle: (channel: number) => string
  /** Uniform with the scale per layer. */
  uniform?: string
  /** Expression for the value, from the stored value and the scale. */
  decode?: (stored: string, scale: string) => string
  /** Required declarations. */
  functions?: string
}

const component = (channel: number) => `[${channel}]`

const VALUES: Record<ValueKind, ValueReading> = {
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

/** Declares the samplers of the value maps, and `void furrowReadValues()`, which reads each texel once. */
export function valueReading(values: Values): string {
  const texels = listTexels(values)
  const samplers = new Set(texels.map(({ sampler }) => sampler))
  const declared = [...samplers].map((sampler) => `uniform highp sampler2DArray furrow_${sampler};`)
  const variables = texels.map(({ name }) => `vec4 ${name} = vec4(0.0);`)
  const statements = texels.map(
    ({ name, sampler, slice }) => `${name} = furrowSampleSlice(furrow_${sampler}, ${slice}.0);`,
  )
  return /* glsl */ `
${[...declared, ...variables].join('\n')}
void furrowReadValues() {
  ${statements.join('\n  ')}
}
`
}

/** Declares `TYPE furrowMix_KIND(TYPE base)`: `mixValues` of the reference; call `furrowReadValues` first. */
export function valueMixing(kind: ValueKind, { slices, channel, sampler }: ValueLayers): string {
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

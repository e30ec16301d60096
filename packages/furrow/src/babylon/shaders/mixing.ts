/**
 * Generates shader functions in GLSL or WGSL that mix the maps of wrinkle layers into the maps of a material. The functions compute the same
 * as `core/reference.ts`.
 */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../core/blood.ts'
import { SMALLEST_ONSET_RANGE } from '../../core/limits.ts'
import type { LayerKind } from '../../core/types.ts'
import type { MixedKind, ValueKind } from '../../runtime/maps/layer-maps.ts'
import { sharesOf } from '../../runtime/maps/layer-shares.ts'
import { listTexels, texelOf, type ValueLayers, type ValueTexel } from '../../runtime/maps/value-texels.ts'
import type { Dialect } from './dialect.ts'

/** Properties of a wrinkle set that decide the code of its shader. The number of areas is not one of them. */
export interface MixedLayers {
  readonly kinds: readonly LayerKind[]
  /** For each layer, the slice that stores its normals. */
  readonly normals: readonly (number | null)[]
  readonly values: Readonly<Partial<Record<ValueKind, ValueLayers>>>
}

const CHANNELS = ['x', 'y', 'z', 'w'] as const
const influenceOf = (layer: number) => `furrowInfluence.${CHANNELS[layer]}`

/** Returns the name of the texture that stores one kind of map. */
export const samplerOf = (kind: 'normal' | ValueKind) => `furrowMaps_${kind}`

/**
 * Declares `furrowMixNormals` and, for each kind of map in the set, `furrowMix_KIND`. Also declares `furrowBloodColour` if the set has blood
 * maps, and `furrowMicroShadow` if it has occlusion maps.
 */
export function mixing(d: Dialect, { kinds, normals, values }: MixedLayers): string {
  const texels = listTexels(values)
  const { onset, ...mixed } = values
  return [
    sampledInfluence(d, kinds.length),
    ...texels.map(({ name }) => d.global(d.vec4, name, `${d.vec4}(0.0)`)),
    ...['normal' as const, ...new Set(texels.map(({ sampler }) => sampler))].map((kind) =>
      sampledMaps(d, kind),
    ),
    onset ? onsetInfluence(d) : '',
    normalMixing(d, kinds, normals, texels, onset),
    ...Object.entries(mixed).map(([kind, layers]) => valueMixing(d, kind as MixedKind, layers)),
    values.occlusion ? microShadow(d) : '',
    values.blood ? bloodColour(d) : '',
  ].join('\n')
}

/**
 * Declares `furrowSampleInfluence(vec2 uv)`, which samples the influences of all layers at a point. The code always samples, because a
 * branch costs GPUs more than the samples that it would save. Derivatives are computed from the texture coordinates before wrapping, because
 * wrapped coordinates jump between neighbouring pixels.
 */
function sampledInfluence(d: Dialect, layers: number): string {
  const { float, vec2, vec4 } = d
  const [dx, dy] = d.derivatives('uv')
  const names = ['furrowPlace', 'furrowInside', 'furrowGrid', 'furrowLimit']
  const [place, inside, grid, limit] = names.map(d.uniform)
  const channels = CHANNELS.map((channel, i) => (i < layers ? `sampled.${channel}` : '0.0'))
  const sampled = d.sampleTexture('furrowInfluenceMap', `corner + inside * ${place}.zw`)
  const body = `
#ifdef FURROW_TILED
  furrowUv = uv - max(ceil(uv) - 1.0, min(floor(uv), ${vec2}(0.0)));
  furrowDx = ${dx};
  furrowDy = ${dy};
#else
  furrowUv = uv;
#endif
#ifdef FURROW_CELLS
  ${d.local(float, 'index', `floor(${d.passed('vFurrowCell')} + 0.5)`)}
  ${d.local(float, 'row', `floor((index + 0.5) / ${grid}.x)`)}
  ${d.local(vec2, 'corner', `(${vec2}(index - row * ${grid}.x, row) + ${grid}.zw) / ${grid}.xy`)}
#else
  ${d.local(vec2, 'corner', `${place}.xy`)}
#endif
  ${d.local(vec2, 'inside', `clamp(furrowUv * ${inside}.xy + ${inside}.zw, ${vec2}(0.0), ${vec2}(1.0))`)}
  ${d.local(vec4, 'sampled', `min(${sampled}, ${vec4}(${limit}.x))`)}
  furrowInfluence = ${vec4}(${channels.join(', ')});`
  return `
#ifdef FURROW_CELLS
${d.isWgsl ? 'varying vFurrowCell: f32;' : 'varying float vFurrowCell;'}
#endif
${d.texture('furrowInfluenceMap')}
${d.global(vec4, 'furrowInfluence', `${vec4}(0.0)`)}
${d.global(vec2, 'furrowUv', `${vec2}(0.0)`)}
${d.global(vec2, 'furrowDx', `${vec2}(0.0)`)}
${d.global(vec2, 'furrowDy', `${vec2}(0.0)`)}
${d.declare(null, 'furrowSampleInfluence', [[vec2, 'uv']], body)}`
}

/** Declares the texture array of one kind of map, and `vec4 furrowSample_KIND(int slice)`, which samples it. */
function sampledMaps(d: Dialect, kind: 'normal' | ValueKind): string {
  const body = `
#ifdef FURROW_TILED
  return ${d.sampleArrayBy(samplerOf(kind), 'furrowUv', 'slice', 'furrowDx', 'furrowDy')};
#else
  return ${d.sampleArray(samplerOf(kind), 'furrowUv', 'slice')};
#endif`
  return `${d.arrayOfMaps(samplerOf(kind))}\n${d.declare(d.vec4, `furrowSample_${kind}`, [[d.int, 'slice']], body)}`
}

/**
 * Declares `vec3 furrowMixNormals(vec3 stored, vec2 uv)`. `stored` is the normal in the material's map. `stored` and the result are encoded
 * in 0..1. If all influences are 0, the result is exactly `stored`.
 *
 * Materials read their normal map first, so this function runs before the functions of other maps. It prepares data for these functions:
 * it samples the layers' other maps, and applies the onset maps to `furrowInfluence`.
 */
function normalMixing(
  d: Dialect,
  kinds: readonly LayerKind[],
  normals: MixedLayers['normals'],
  texels: readonly ValueTexel[],
  onset: ValueLayers | undefined,
): string {
  const { float, vec2, vec3 } = d
  const scales = d.uniform('furrowNormalScale')
  const layers = kinds.map((kind, layer) => {
    // For detail layers, n.z is half the unpacked z. The constant is slightly less than 0.5, so that n.z, which divides in the next lines, is never 0.
    // The components x and y are unpacked in `slope`.
    const unpacked = kind === 'detail' ? `- ${vec3}(0.0, 0.0, 0.4999999)` : '* 2.0 - 1.0'
    return `
  ${d.local(vec3, `n${layer}`, `furrowSample_normal(${normals[layer]!}).xyz ${unpacked}`)}`
  })
  const values = texels.map(
    ({ name, sampler, slice }) => `
  ${name} = furrowSample_${sampler}(${slice});`,
  )
  const scaleOf = (layer: number) => `${scales}.${CHANNELS[layer]}`
  const replacing = indicesOf(kinds, 'replace')
  const details = indicesOf(kinds, 'detail')
  const shares = sharesOf(replacing.map(influenceOf))
  const replaced = replacing.map((layer, i) => {
    const scaled = `n${layer} * ${vec3}(${scaleOf(layer)}, ${scaleOf(layer)}, 1.0)`
    return ` + (${scaled} - base) * (${shares[i]})`
  })
  const factors = details.map(
    (layer) => `
  ${d.local(float, `k${layer}`, `${influenceOf(layer)} * ${scaleOf(layer)} / n${layer}.z`)}`,
  )
  const slope = details.map((layer) => `n${layer}.xy * k${layer} - 0.5 * k${layer}`).join(' + ')
  // This is the formula of reoriented normal mapping, expanded such that a slope of 0 does not change the normal. The constant 1e-6 keeps
  // normal.z + size above 0.
  const reoriented = `${factors.join('')}
  ${d.local(vec2, 'slope', slope)}
  ${d.local(float, 'size', 'sqrt(dot(normal, normal) + 1e-6)')}
  ${d.local(float, 'along', 'dot(normal.xy, slope)')}
  ${d.local(float, 'kept', '1.0 - along / (normal.z + size)')}
  normal = ${vec3}(normal.xy * kept + slope * size, normal.z - along);
#ifdef DETAIL
  // Babylon.js blends a detail map with this normal, and the result depends on the length. So restore the length of the original normal.
  normal = normal * (size / length(normal));
#endif`
  const body = `
  furrowSampleInfluence(uv);
  ${d.local(vec3, 'base', 'stored * 2.0 - 1.0')}${[...layers, ...values, onset ? applyOnset(d, kinds.length, onset) : ''].join('')}
  ${d.local(vec3, 'normal', `base${replaced.join('')}`)}${details.length > 0 ? reoriented : ''}
  return normal * 0.5 + 0.5;`
  const parameters = [
    [vec3, 'stored'],
    [vec2, 'uv'],
  ] as const
  return d.declare(vec3, 'furrowMixNormals', parameters, body)
}

/** For each kind of map, how a stored value is decoded. `scales` names a uniform with one factor per layer. `decode` receives the factor. */
const VALUES: Record<MixedKind, { scales?: string; decode(stored: string, scale: string): string }> = {
  baseColor: { decode: (stored) => stored },
  roughness: { decode: (stored) => stored },
  occlusion: {
    scales: 'furrowOcclusionStrength',
    decode: (stored, strength) => `1.0 + (${stored} - 1.0) * ${strength}`,
  },
  blood: {
    scales: 'furrowBloodAmplitude',
    decode: (stored, amplitude) => `furrowBloodOf(${stored}) * ${amplitude}`,
  },
}

/** Declares `vec3 furrowMix_KIND(vec3 base)`, which mixes the layers' values into `base`. For single-channel maps, all components are equal. */
function valueMixing(d: Dialect, kind: MixedKind, { slices, channel, sampler }: ValueLayers): string {
  const { vec3 } = d
  const { scales, decode } = VALUES[kind]
  const layers = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
  const shares = sharesOf(layers.map(({ layer }) => influenceOf(layer)))
  const mixed = layers.map(({ slice, layer }, i) => {
    const stored = `${texelOf(sampler, slice)}.${kind === 'baseColor' ? 'xyz' : CHANNELS[channel]}`
    const value = decode(stored, scales ? `${d.uniform(scales)}.${CHANNELS[layer]}` : '')
    return ` + (${vec3}(${value}) - base) * (${shares[i]})`
  })
  const body = `
  return base${mixed.join('')};`
  return [
    kind === 'blood' ? bloodOf(d) : '',
    d.declare(vec3, `furrowMix_${kind}`, [[vec3, 'base']], body),
  ].join('\n')
}

/** Declares `float furrowOnsetInfluence(float influence, float onset, float strength)`; see `onsetInfluence` in `core/reference.ts`. */
function onsetInfluence(d: Dialect): string {
  const { float } = d
  const body = `
  ${d.local(float, 't', `clamp(1.0 - (1.0 - influence) / max(1.0 - onset, ${SMALLEST_ONSET_RANGE}), 0.0, 1.0)`)}
  return influence + (t * (2.0 - t) - influence) * strength;`
  const parameters = ['influence', 'onset', 'strength'].map((name) => [float, name] as const)
  return d.declare(float, 'furrowOnsetInfluence', parameters, body)
}

/** Returns a statement that applies the onset maps to `furrowInfluence`. Layers without an onset map keep their influence. */
function applyOnset(d: Dialect, layers: number, { slices, channel, sampler }: ValueLayers): string {
  const strengths = d.uniform('furrowOnsetStrength')
  const influences = CHANNELS.map((letter, layer) => {
    const slice = slices[layer] ?? null
    if (layer >= layers || slice === null) return `furrowInfluence.${letter}`
    const onset = `${texelOf(sampler, slice)}.${CHANNELS[channel]}`
    return `furrowOnsetInfluence(furrowInfluence.${letter}, ${onset}, ${strengths}.${letter})`
  })
  return `
  furrowInfluence = ${d.vec4}(${influences.join(', ')});`
}

/** Declares `float furrowBloodOf(float stored)`; see `bloodOf` in `core/reference.ts`. */
function bloodOf(d: Dialect): string {
  const body = `
  ${d.local(d.float, 'steps', `stored * 255.0 - ${BLOOD_AT_REST}.0`)}
  return max(steps / ${255 - BLOOD_AT_REST}.0, -1.0) * step(${BLOOD_THRESHOLD}, abs(steps));`
  return d.declare(d.float, 'furrowBloodOf', [[d.float, 'stored']], body)
}

/** Declares `vec3 furrowBloodColour(vec3 colour)`, for linear colours; see `bloodColour` in `core/reference.ts`. */
function bloodColour(d: Dialect): string {
  const { vec3 } = d
  const absorption = `${vec3}(${BLOOD_ABSORPTION.map((value) => value.toFixed(2)).join(', ')})`
  const body = `
  return colour * exp(-furrowMix_blood(${vec3}(0.0)).x * ${absorption});`
  return d.declare(vec3, 'furrowBloodColour', [[vec3, 'colour']], body)
}

/** Declares `float furrowMicroShadow(float cosine)`; see `microShadow` in `core/reference.ts`. */
function microShadow(d: Dialect): string {
  const body = `
  ${d.local(d.float, 'cone', '1.0 - furrowVisibility')}
  if (cosine * cosine < cone) { return cosine * cosine / cone; }
  return 1.0;`
  return [
    d.global(d.float, 'furrowVisibility', '1.0'),
    d.declare(d.float, 'furrowMicroShadow', [[d.float, 'cosine']], body),
  ].join('\n')
}

function indicesOf(kinds: readonly LayerKind[], kind: LayerKind): number[] {
  return kinds.flatMap((each, layer) => (each === kind ? [layer] : []))
}

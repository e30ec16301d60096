/** Generates GLSL and WGSL that mixes the layers' maps into those of the material, like `mixNormals` and `mixValues` of the reference. */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../core/blood.ts'
import type { LayerKind } from '../../core/types.ts'
import type { ValueKind } from '../../runtime/layer-maps.ts'
import { sharesOf } from '../../runtime/layer-shares.ts'
import { listTexels, texelOf, type ValueLayers, type ValueTexel } from '../../runtime/value-texels.ts'
import type { Dialect } from './dialect.ts'

/** Shader parameters. Independent of the number of areas. */
export interface MixedLayers {
  readonly kinds: readonly LayerKind[]
  /** Slice of each layer's normals. */
  readonly normals: readonly (number | null)[]
  readonly values: Readonly<Partial<Record<ValueKind, ValueLayers>>>
}

const CHANNELS = ['x', 'y', 'z', 'w'] as const
const influenceOf = (layer: number) => `furrowInfluence.${CHANNELS[layer]}`

/** Name of the texture of one kind of map. */
export const samplerOf = (kind: 'normal' | ValueKind) => `furrowMaps_${kind}`

/** Declares `furrowMixNormals`, and, if there are maps for them, `furrowMix_KIND`, `furrowBloodColour` and `furrowMicroShadow`. */
export function mixing(d: Dialect, { kinds, normals, values }: MixedLayers): string {
  const texels = listTexels(values)
  return [
    sampledInfluence(d, kinds.length),
    ...texels.map(({ name }) => d.global(d.vec4, name, `${d.vec4}(0.0)`)),
    ...['normal' as const, ...new Set(texels.map(({ sampler }) => sampler))].map((kind) =>
      sampledMaps(d, kind),
    ),
    normalMixing(d, kinds, normals, texels),
    ...Object.entries(values).map(([kind, layers]) => valueMixing(d, kind as ValueKind, layers)),
    values.occlusion ? microShadow(d) : '',
    values.blood ? bloodColour(d) : '',
  ].join('\n')
}

/**
 * Declares `furrowSampleInfluence(vec2 uv)`, which samples the influence of all layers. Branch-free: branches cost GPUs more than the samples
 * that they would save. Wrapping texture coordinates need derivatives from before the wrap.
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

/** Declares a texture array, and `vec4 furrowSample_KIND(int slice)`. */
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
 * Declares `vec3 furrowMixNormals(vec3 stored, vec2 uv)`. Argument and result are normals encoded in 0..1, as in the map. If the influence is
 * 0, the result equals `stored` bit by bit. The function also samples the value maps, because shaders read the normal map first.
 */
function normalMixing(
  d: Dialect,
  kinds: readonly LayerKind[],
  normals: MixedLayers['normals'],
  texels: readonly ValueTexel[],
): string {
  const { float, vec2, vec3 } = d
  const scales = d.uniform('furrowNormalScale')
  const layers = kinds.map((kind, layer) => {
    // Detail layers unpack only z here, halved, and x and y below, together with the factor k. The halved z is slightly too large, so that
    // it is never 0: at an influence of 0, k would be 0 / 0.
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
  // Expanded like `reorientBy` in three/webgpu: a slope of 0 keeps the normal. The epsilon keeps z + size above 0.
  const reoriented = `${factors.join('')}
  ${d.local(vec2, 'slope', slope)}
  ${d.local(float, 'size', 'sqrt(dot(normal, normal) + 1e-6)')}
  ${d.local(float, 'along', 'dot(normal.xy, slope)')}
  ${d.local(float, 'kept', '1.0 - along / (normal.z + size)')}
  normal = ${vec3}(normal.xy * kept + slope * size, normal.z - along);
#ifdef DETAIL
  // Babylon.js adds its own detail map to this normal and expects its length unchanged. Without that map, Babylon.js normalises the result.
  normal = normal * (size / length(normal));
#endif`
  const body = `
  furrowSampleInfluence(uv);
  ${d.local(vec3, 'base', 'stored * 2.0 - 1.0')}${[...layers, ...values].join('')}
  ${d.local(vec3, 'normal', `base${replaced.join('')}`)}${details.length > 0 ? reoriented : ''}
  return normal * 0.5 + 0.5;`
  const parameters = [
    [vec3, 'stored'],
    [vec2, 'uv'],
  ] as const
  return d.declare(vec3, 'furrowMixNormals', parameters, body)
}

/** By kind of map: the name of the uniform that holds a factor per layer, if any, and an expression that decodes a stored value. */
const VALUES: Record<ValueKind, { scales?: string; decode(stored: string, scale: string): string }> = {
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

/** Declares `vec3 furrowMix_KIND(vec3 base)`. Kinds with one value per texel repeat it in all three components. */
function valueMixing(d: Dialect, kind: ValueKind, { slices, channel, sampler }: ValueLayers): string {
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

/** See `bloodOf` in the reference. */
function bloodOf(d: Dialect): string {
  const body = `
  ${d.local(d.float, 'steps', `stored * 255.0 - ${BLOOD_AT_REST}.0`)}
  return max(steps / ${255 - BLOOD_AT_REST}.0, -1.0) * step(${BLOOD_THRESHOLD}, abs(steps));`
  return d.declare(d.float, 'furrowBloodOf', [[d.float, 'stored']], body)
}

/** Declares `vec3 furrowBloodColour(vec3 colour)`, linear, see `bloodColour` in the reference. */
function bloodColour(d: Dialect): string {
  const { vec3 } = d
  const absorption = `${vec3}(${BLOOD_ABSORPTION.map((value) => value.toFixed(2)).join(', ')})`
  const body = `
  return colour * exp(-furrowMix_blood(${vec3}(0.0)).x * ${absorption});`
  return d.declare(vec3, 'furrowBloodColour', [[vec3, 'colour']], body)
}

/** Declares `float furrowMicroShadow(float cosine)`, see `microShadow` in the reference. */
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

/** The layers' maps mixed into the material's own: `mixNormals` and `mixValues` of the reference, in either dialect. */
import { BLOOD_ABSORPTION, BLOOD_AT_REST, BLOOD_THRESHOLD } from '../../core/blood.ts'
import type { LayerKind } from '../../core/types.ts'
import type { ValueKind } from '../../runtime/layer-maps.ts'
import { listTexels, texelOf, type ValueLayers, type ValueTexel } from '../../runtime/value-texels.ts'
import type { Dialect } from './dialect.ts'

/** What the functions depend on: never the number of areas. */
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

/** Declares `furrowMixNormals`, `furrowMix_KIND`, `furrowBloodColour` and `furrowMicroShadow`, as far as there are maps for them. */
export function mixing(d: Dialect, { kinds, normals, values }: MixedLayers): string {
  const texels = listTexels(values)
  return [
    sampledInfluence(d, kinds.length),
    ...texels.map(({ name }) => d.global(d.vec4, name, `${d.vec4}(0.0)`)),
    ...[...new Set(texels.map(({ sampler }) => samplerOf(sampler)))].map(d.arrayOfMaps),
    normalMixing(d, kinds, normals, texels),
    ...Object.entries(values).map(([kind, layers]) => valueMixing(d, kind as ValueKind, layers)),
    values.occlusion ? microShadow(d) : '',
    values.blood ? bloodColour(d) : '',
  ].join('\n')
}

/**
 * The influence of each layer: one sample of the map, at coordinates whose derivatives are taken here, since the layers' maps are sampled
 * inside branches, where neighbouring pixels may diverge.
 */
function sampledInfluence(d: Dialect, layers: number): string {
  const { float, vec2, vec4 } = d
  const [dx, dy] = d.derivatives('unwrapped')
  const [grid, inset, bounds] = ['furrowGrid', 'furrowInset', 'furrowBounds'].map(d.uniform)
  const channels = CHANNELS.map((channel, i) => (i < layers ? `sampled.${channel}` : '0.0'))
  const sampled = d.sampleTexture('furrowInfluenceMap', `(corner + inside) / ${grid}.xy`)
  const body = `
  ${d.local(vec2, 'uv', `unwrapped - max(ceil(unwrapped) - 1.0, min(floor(unwrapped), ${vec2}(0.0)))`)}
  furrowUv = uv;
  furrowDx = ${dx};
  furrowDy = ${dy};
  if (uv.x < ${bounds}.x || uv.y < ${bounds}.y || uv.x > ${bounds}.z || uv.y > ${bounds}.w) { return 0.0; }
#ifdef FURROW_CELLS
  ${d.local(float, 'cell', `floor(${d.passed('vFurrowCell')} + 0.5)`)}
#else
  ${d.local(float, 'cell', `${grid}.z`)}
#endif
  ${d.local(float, 'row', `floor((cell + 0.5) / ${grid}.x)`)}
  ${d.local(vec2, 'corner', `${vec2}(cell - row * ${grid}.x, row)`)}
  ${d.local(vec2, 'inside', `clamp(uv, ${inset}.xy, 1.0 - ${inset}.xy)`)}
  ${d.local(vec4, 'sampled', `min(${sampled}, ${vec4}(1.0))`)}
  furrowInfluence = ${vec4}(${channels.join(', ')});
  return max(max(furrowInfluence.x, furrowInfluence.y), max(furrowInfluence.z, furrowInfluence.w));`
  return `
#ifdef FURROW_CELLS
${d.isWgsl ? 'varying vFurrowCell: f32;' : 'varying float vFurrowCell;'}
#endif
${d.texture('furrowInfluenceMap')}
${d.global(vec4, 'furrowInfluence', `${vec4}(0.0)`)}
${d.global(float, 'furrowLargest', '0.0')}
${d.global(vec2, 'furrowUv', `${vec2}(0.0)`)}
${d.global(vec2, 'furrowDx', `${vec2}(0.0)`)}
${d.global(vec2, 'furrowDy', `${vec2}(0.0)`)}
${d.declare(float, 'furrowSampleInfluence', [[vec2, 'unwrapped']], body)}`
}

/**
 * Declares `vec3 furrowMixNormals(vec3 stored, vec2 unwrapped)`: the normal as stored, 0..1, which stays as it is without influence. Shaders read
 * their normal map before the others, so that it reads the texels of these too.
 */
function normalMixing(
  d: Dialect,
  kinds: readonly LayerKind[],
  normals: MixedLayers['normals'],
  texels: readonly ValueTexel[],
): string {
  const { float, vec2, vec3 } = d
  const texture = samplerOf('normal')
  const scales = d.uniform('furrowNormalScale')
  const layers = kinds.map((kind, layer) => {
    const scale = `${scales}.${CHANNELS[layer]}`
    const sampled = sample(d, texture, normals[layer]!)
    return `
  ${d.local(vec3, `n${layer}`, kind === 'replace' ? 'base' : `${vec3}(0.0, 0.0, 1.0)`)}
  if (${influenceOf(layer)} > 0.0) { n${layer} = (${sampled}.xyz * 2.0 - 1.0) * ${vec3}(${scale}, ${scale}, 1.0); }`
  })
  const values = texels.map(({ name, sampler, slice, layers: owners }) => {
    const isShown = owners.map(influenceOf).join(' + ')
    return `
  if (${isShown} > 0.0) { ${name} = ${sample(d, samplerOf(sampler), slice)}; }`
  })
  const replacing = indicesOf(kinds, 'replace')
  const details = indicesOf(kinds, 'detail')
  const replaced = replacing.map((layer) => ` + (n${layer} - base) * ${influenceOf(layer)} / total`)
  const slope = details.map((layer) => `n${layer}.xy / n${layer}.z * ${influenceOf(layer)}`).join(' + ')
  const reoriented = `
  ${d.local(vec3, 'turned', `normalize(normal) + ${vec3}(0.0, 0.0, 1.0)`)}
  ${d.local(vec3, 'detail', `normalize(${vec3}(${slope}, 1.0)) * ${vec3}(-1.0, -1.0, 1.0)`)}
  normal = turned * (dot(turned, detail) / turned.z) - detail;`
  const body = `
  furrowLargest = furrowSampleInfluence(unwrapped);
  if (furrowLargest <= 0.0) { return stored; }
  ${d.local(vec3, 'base', 'stored * 2.0 - 1.0')}${[...layers, ...values].join('')}
  ${d.local(float, 'total', `max(1.0, ${[...replacing.map(influenceOf), '0.0'].join(' + ')})`)}
  ${d.local(vec3, 'normal', `base${replaced.join('')}`)}${details.length > 0 ? reoriented : ''}
  return normal * 0.5 + 0.5;`
  const parameters = [
    [vec3, 'stored'],
    [vec2, 'unwrapped'],
  ] as const
  return `${d.arrayOfMaps(texture)}\n${d.declare(vec3, 'furrowMixNormals', parameters, body)}`
}

/** How the values of a kind are read. */
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

/** Declares `vec3 furrowMix_KIND(vec3 base)`; single values are in all three components. */
function valueMixing(d: Dialect, kind: ValueKind, { slices, channel, sampler }: ValueLayers): string {
  const { float, vec3 } = d
  const { scales, decode } = VALUES[kind]
  const layers = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
  const total = layers.map(({ layer }) => influenceOf(layer)).join(' + ')
  const mixed = layers.map(({ slice, layer }) => {
    const stored = `${texelOf(sampler, slice)}.${kind === 'baseColor' ? 'xyz' : CHANNELS[channel]}`
    const value = decode(stored, scales ? `${d.uniform(scales)}.${CHANNELS[layer]}` : '')
    return `
  value += (${vec3}(${value}) - base) * (${influenceOf(layer)} / total);`
  })
  const body = `
  ${d.local(vec3, 'value', 'base')}
  ${d.local(float, 'total', `max(1.0, ${total})`)}${mixed.join('')}
  return value;`
  return [
    kind === 'blood' ? bloodOf(d) : '',
    d.declare(vec3, `furrowMix_${kind}`, [[vec3, 'base']], body),
  ].join('\n')
}

function sample(d: Dialect, texture: string, slice: number): string {
  return d.sampleArray(texture, 'furrowUv', String(slice), 'furrowDx', 'furrowDy')
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
  return kinds.flatMap((own, layer) => (own === kind ? [layer] : []))
}

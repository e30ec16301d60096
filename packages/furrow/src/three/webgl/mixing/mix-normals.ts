import type { LayerKind } from '../../../core/types.ts'
import { sharesOf } from '../../../runtime/layer-shares.ts'

/** The layers' normals, as a program depends on them. */
export interface NormalLayers {
  kinds: readonly LayerKind[]
  /** Slice of each layer's normals. */
  normals: readonly (number | null)[]
}

/**
 * Declares `vec3 furrowMixNormals(vec3 base)`: `mixNormals` of the reference, of any length, since whoever uses it normalises it; in the direction of
 * the base where the influence of all layers is 0. All layers are sampled: a graphics card pays more for the branches.
 */
export function normalMixing({ kinds, normals }: NormalLayers): string {
  const influence = (layer: number) => `furrowInfluence[${layer}]`
  const sampled = kinds.map((kind, layer) => `\n  vec3 n${layer} = ${layerNormal(kind, normals[layer]!)};`)
  const replacing = indicesOf(kinds, 'replace')
  const details = indicesOf(kinds, 'detail')
  const shares = sharesOf(replacing.map(influence))
  const scaled = (layer: number) => `n${layer} * vec3(vec2(furrowNormalScale[${layer}]), 1.0)`
  const replaced = replacing.map((layer, i) => ` + (${scaled(layer)} - base) * (${shares[i]})`)
  const mixed = `base${replaced.join('')}`
  // The normal of a single one need not be divided by its z, which takes the longest.
  const isOne = details.length === 1
  const factors = details.map(
    (layer) =>
      `\n  float k${layer} = ${influence(layer)} * furrowNormalScale[${layer}]${isOne ? '' : ` / n${layer}.z`};`,
  )
  const slope = details.map((layer) => `n${layer}.xy * k${layer} - 0.5 * k${layer}`).join(' + ')
  const depth = isOne ? `abs(n${details[0]}.z)` : '1.0'
  return /* glsl */ `
uniform highp sampler2DArray furrowNormals;
uniform vec4 furrowNormalScale;
${details.length > 0 ? DETAILS : ''}
vec3 furrowMixNormals(vec3 base) {
${sampled.join('')}${factors.join('')}
  return ${details.length > 0 ? `furrowReorient(${mixed}, ${slope}, ${depth})` : mixed};
}
`
}

/** The normal of a layer: of one of detail, x and y as stored, which are unpacked with their factor, and half of z. */
function layerNormal(kind: LayerKind, slice: number): string {
  return `furrowSampleSlice(furrowNormals, ${slice}.0).xyz ${kind === 'detail' ? '- FURROW_FLAT' : '* 2.0 - 1.0'}`
}

/**
 * `FURROW_FLAT` takes half of z from what is stored, but for a little: a z of exactly 0 would leave no normal, or divide an influence of 0 by 0.
 *
 * `furrowReorient` is reoriented normal mapping, see `reorientNormal` in the reference: the same direction, of a base of any length, and of a detail with
 * this slope times its depth. With the base's length l, t = (x, y, z + l) and r = (-slope, depth), t dot(t, r) / t.z - l r is multiplied out, so that a slope of 0 leaves
 * the base's direction. What is added to the length keeps z + l from 0; a limit would be one step more.
 */
const DETAILS = /* glsl */ `
const vec3 FURROW_FLAT = vec3(0.0, 0.0, 0.4999999);

vec3 furrowReorient(vec3 base, vec2 slope, float depth) {
  float size = sqrt(base.x * base.x + (base.y * base.y + (base.z * base.z + 1e-6)));
  float along = dot(base.xy, slope);
  return vec3(base.xy * (depth - along / (base.z + size)) + slope * size, base.z * depth - along);
}
`

function indicesOf(kinds: readonly LayerKind[], kind: LayerKind): number[] {
  return kinds.flatMap((own, layer) => (own === kind ? [layer] : []))
}

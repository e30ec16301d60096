import type { LayerKind } from '../../../core/types.ts'
import { sharesOf } from '../../../runtime/layer-shares.ts'

/** Parameters of `normalMixing`. */
export interface NormalLayers {
  kinds: readonly LayerKind[]
  /** Slice of each layer's normals. */
  normals: readonly (number | null)[]
}

/**
 * Declares `vec3 furrowMixNormals(vec3 base)`: `mixNormals` of the reference, not normalised. Keeps the direction of the base if the
 * influence of all layers is 0. Samples all layers, because branches cost more on GPUs.
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
  // A single detail normal needs no division by z, the most expensive operation.
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

/** Normal of a layer. For a detail layer: stored x and y, unpacked later with their factor, and half of z. */
function layerNormal(kind: LayerKind, slice: number): string {
  return `furrowSampleSlice(furrowNormals, ${slice}.0).xyz ${kind === 'detail' ? '- FURROW_FLAT' : '* 2.0 - 1.0'}`
}

/**
 * `FURROW_FLAT` subtracts slightly less than half from z. A z of exactly 0 would give a zero vector, or 0 / 0 at an influence of 0.
 *
 * `furrowReorient` is reoriented normal mapping (`reorientNormal` in the reference). The base (x, y, z) may have any length l, and `slope`
 * is premultiplied by `depth`. The code expands `t * dot(t, r) / t.z - l * r`, where `t = (x, y, z + l)` and `r = (-slope, depth)`. A slope
 * of 0 keeps the base's direction. The epsilon in l keeps `z + l` above 0, and is cheaper than a clamp.
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
  return kinds.flatMap((each, layer) => (each === kind ? [layer] : []))
}

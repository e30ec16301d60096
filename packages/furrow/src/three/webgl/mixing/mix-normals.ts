import type { LayerKind } from '../../../core/types.ts'
import { sharesOf } from '../../../runtime/layer-shares.ts'

/** The layers' normals, as a program depends on them. */
export interface NormalLayers {
  kinds: readonly LayerKind[]
  /** Slice of each layer's normals. */
  normals: readonly (number | null)[]
}

/**
 * Declares `vec3 furrowMixNormals(vec3 base)`: `mixNormals` of the reference, of any length, since whoever uses it normalises it; the base
 * itself, bit by bit, where the influence of all layers is 0. All layers are sampled: a graphics card pays more for the branches.
 */
export function normalMixing({ kinds, normals }: NormalLayers): string {
  const influence = (layer: number) => `furrowInfluence[${layer}]`
  const sampled = normals.map(
    (slice, layer) =>
      `\n  vec3 n${layer} = furrowSampleSlice(furrowNormals, ${slice}.0).xyz * 2.0 - FURROW_ONE;`,
  )
  const replacing = indicesOf(kinds, 'replace')
  const details = indicesOf(kinds, 'detail')
  const shares = sharesOf(replacing.map(influence))
  const scaled = (layer: number) => `n${layer} * vec3(vec2(furrowNormalScale[${layer}]), 1.0)`
  const replaced = replacing.map((layer, i) => ` + (${scaled(layer)} - base) * (${shares[i]})`)
  const slope = details
    .map((layer) => `n${layer}.xy * (${influence(layer)} * furrowNormalScale[${layer}] / n${layer}.z)`)
    .join(' + ')
  const mixed = `base${replaced.join('')}`
  return /* glsl */ `
uniform highp sampler2DArray furrowNormals;
uniform vec4 furrowNormalScale;
${ONE}${details.length > 0 ? REORIENT : ''}
vec3 furrowMixNormals(vec3 base) {
${sampled.join('')}
  return ${details.length > 0 ? `furrowReorient(${mixed}, ${slope})` : mixed};
}
`
}

/** A z of exactly 0 would divide an influence of 0 by 0. */
const ONE = 'const vec3 FURROW_ONE = vec3(1.0, 1.0, 0.9999999);'

/**
 * Reoriented normal mapping, see `reorientNormal` in the reference: the same direction, of a base of any length and the slopes of the detail.
 * With the base's length l, t = (x, y, z + l) and r = (-slope, 1), t dot(t, r) / t.z - l r is multiplied out, so that a slope of 0 leaves the base
 * as it is without a choice between the two.
 */
const REORIENT = /* glsl */ `
vec3 furrowReorient(vec3 base, vec2 slope) {
  float size = length(base);
  float along = dot(base.xy, slope);
  return vec3(base.xy * (1.0 - along / max(base.z + size, 1e-6)) + slope * size, base.z - along);
}
`

function indicesOf(kinds: readonly LayerKind[], kind: LayerKind): number[] {
  return kinds.flatMap((own, layer) => (own === kind ? [layer] : []))
}

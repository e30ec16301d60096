import type { LayerKind } from '../../../core/types.ts'
import { sharesOf } from '../../../runtime/maps/layer-shares.ts'

export interface NormalLayers {
  kinds: readonly LayerKind[]
  /** Slice of each layer's normal map in the texture array. */
  normals: readonly (number | null)[]
}

/**
 * Returns GLSL that declares `vec3 furrowMixNormals(vec3 base)`. The function mixes the normals of layers into the normal `base` of the
 * material, like `mixNormals` of the reference implementation, but does not normalise the result. If the influence of all layers is 0, the
 * result has the direction of `base`. The function samples all layers, because on GPUs a branch costs more than the samples that it skips. A
 * layer of kind `replace` takes the place of the material's normal map, and a detail layer adds wrinkles on top of it.
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
  // With a single detail layer, `slope` and `depth` are both scaled by the z of the layer's normal, to avoid an expensive division by z.
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

/**
 * Returns GLSL that reads the normal of a layer. For a detail layer it returns the stored x and y, in 0..1, and half of z. Unpacking x and y
 * later, in `furrowMixNormals`, takes fewer operations.
 */
function layerNormal(kind: LayerKind, slice: number): string {
  return `furrowSampleSlice(furrowNormals, ${slice}.0).xyz ${kind === 'detail' ? '- FURROW_FLAT' : '* 2.0 - 1.0'}`
}

/**
 * Subtracting `FURROW_FLAT` from a stored normal gives half of the unpacked z, because z is stored as `z / 2 + 0.5`. The constant is slightly
 * below 0.5, so that the difference is never 0. A difference of 0 would give wrong results while the influence is 0: a zero vector with one
 * detail layer, and 0 / 0 with several.
 *
 * `furrowReorient` is reoriented normal mapping (`reorientNormal` in the reference implementation). `base` is a vector (x, y, z) of any length
 * l. `slope` is the slope of the detail normal times `depth`. The code expands `t * dot(t, r) / t.z - l * r`, where `t = (x, y, z + l)` and
 * `r = (-slope, depth)`. If `slope` is 0, the result has the direction of `base`. The epsilon 1e-6 keeps `z + l` above 0, and is cheaper than
 * a clamp.
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

/**
 * TSL that mixes the normals of layers into the normal of a material. A layer of kind `replace` takes the place of the material's normal map,
 * and a detail layer adds wrinkles on top of it. The formulas are those of the GLSL in `webgl/`, and of the reference implementation in
 * `core/reference`.
 */
import { float, max, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { LayerKind } from '../../../core/types.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { CHANNELS, inputUniform } from '../node.ts'
import type { SliceSampler } from '../texture-sampling.ts'

/** Influence of the layers, and how to sample their maps. */
export interface LayerInfluence {
  /** Influence of layers 0..3 in x, y, z, w, each 0..1. */
  influence: Node<'vec4'>
  /** Texture coordinates of the maps. */
  uv: Node<'vec2'>
  sampler: SliceSampler
  /** Cache of the texels of value maps, so that each slice is sampled once. */
  texels: Map<string, Node<'vec4'>>
}

/** Applies a detail normal to a base normal by reoriented normal mapping, see `reorientNormal` in the reference. Both are unit vectors. */
export function reorient(base: Node<'vec3'>, detail: Node<'vec3'>): Node<'vec3'> {
  return reorientBy(base, lengthOf(base), detail.xy, detail.z)
}

/**
 * Applies a detail normal to a base normal (x, y, z) of length `size` by reoriented normal mapping. The code expands
 * `t * dot(t, r) / t.z - size * r`, where `t = (x, y, z + size)` and `r = (-slope, depth)`. If `slope` is 0, the result has the direction of
 * the base.
 *
 * @param slope slope of the detail normal, times `depth`.
 * @param depth z of the detail normal; 1 if `slope` is already divided by z.
 */
function reorientBy(
  base: Node<'vec3'>,
  size: Node<'float'>,
  slope: Node<'vec2'>,
  depth: Node<'float'>,
): Node<'vec3'> {
  const along = base.xy.dot(slope).toVar()
  const shrunk = depth.sub(along.div(base.z.add(size)))
  return vec3(base.xy.mul(shrunk).add(slope.mul(size)), base.z.mul(depth).sub(along))
}

/** Returns the length of a normal. The epsilon keeps `z + length` above 0, and is cheaper than a clamp. */
function lengthOf(normal: Node<'vec3'>): Node<'float'> {
  return normal.dot(normal).add(1e-6).sqrt()
}

/**
 * Mixes the normals of all layers into the normal of the material, see `mixNormals` in the reference.
 *
 * @param base tangent-space normal of the material, components -1..1.
 * @returns a normal of any length. It has the direction of `base` if the influence of all layers is 0.
 */
export function mixNormals(
  base: Node<'vec3'>,
  inputs: ShaderInputs,
  { influence, uv, sampler }: Omit<LayerInfluence, 'texels'>,
): Node<'vec3'> {
  const { kinds, normals } = inputs.textures
  const scales = inputUniform<'vec4'>(inputs.normalScale)
  const baseNormal = base.toVar()
  const sample = sampler(uv)
  // The constant is slightly below 0.5, so that the z of a sampled normal is never 0. While the influence is 0, the result would otherwise be
  // a zero vector or 0 / 0.
  const flat = vec3(0, 0, 0.4999999)
  const layers = kinds.map((kind, layer) => {
    const stored = sample(normals.texture, normals.slices[layer]!).xyz
    return {
      kind,
      influence: influence[CHANNELS[layer]],
      scale: scales[CHANNELS[layer]],
      normal: (kind === 'detail' ? stored.sub(flat) : unpack(stored)).toVar(),
    }
  })
  const replaced = replaceNormal(baseNormal, filterByKind('replace', layers))
  const details = filterByKind('detail', layers)
  if (details.length === 0) return replaced
  const size = lengthOf(replaced).toVar()
  // With a single detail layer, `slope` and `depth` are both scaled by the z of the layer's normal, to avoid an expensive division by z.
  const isOne = details.length === 1
  const depth = isOne ? details[0].normal.z.abs() : float(1)
  return reorientBy(replaced, size, slopeOf(details, isOne), depth)
}

interface SampledLayer {
  kind: LayerKind
  influence: Node<'float'>
  scale: Node<'float'>
  /** Normal with components -1..1. For a detail layer, the stored x and y, in 0..1, and half of z; `slopeOf` unpacks x and y. */
  normal: Node<'vec3'>
}

function filterByKind(kind: LayerKind, layers: readonly SampledLayer[]): SampledLayer[] {
  return layers.filter((layer) => layer.kind === kind)
}

export function unpack(stored: Node<'vec3'>): Node<'vec3'> {
  return stored.mul(2).sub(1)
}

/** Mixes the normals of layers of kind `replace` into the base normal. The mixing weights are the shares of the layers, see `sharesOf`. */
function replaceNormal(base: Node<'vec3'>, layers: readonly SampledLayer[]): Node<'vec3'> {
  if (layers.length === 0) return base
  const shares = sharesOf(layers.map(({ influence }) => influence))
  return layers
    .reduce<Node<'vec3'>>(
      (mixed, { scale, normal }, i) =>
        mixed.add(
          normal
            .mul(vec3(scale, scale, 1))
            .sub(base)
            .mul(shares[i]),
        ),
      base,
    )
    .toVar()
}

/** Returns the mixing weights of layers: their influences, divided by the sum of all influences if the sum exceeds 1. */
export function sharesOf(influences: readonly Node<'float'>[]): readonly Node<'float'>[] {
  if (influences.length < 2) return influences
  const sum = influences.reduce((total, influence) => total.add(influence))
  const total = max(float(1), sum).toVar()
  return influences.map((influence) => influence.div(total))
}

/**
 * Sums the slopes of the normals of detail layers, scaled by the influences of the layers.
 *
 * @param isFlat whether to skip the division by z of the normal. The result is then the slope of the single layer, times half of z.
 */
function slopeOf(layers: readonly SampledLayer[], isFlat: boolean): Node<'vec2'> {
  const slopes = layers.map(({ influence, scale, normal }) => {
    const share = influence.mul(scale)
    const factor = (isFlat ? share : share.div(normal.z)).toVar()
    return normal.xy.mul(factor).sub(factor.mul(0.5))
  })
  return slopes.reduce((total, slope) => total.add(slope)).toVar()
}

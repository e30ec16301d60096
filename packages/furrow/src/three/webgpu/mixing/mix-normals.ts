/** Mixing of the layers' normals into the material's own, in TSL; same formulas as the GLSL in `webgl/` and the reference. */
import { float, max, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { LayerKind } from '../../../core/types.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { CHANNELS, inputUniform } from '../node.ts'
import type { SliceSampler } from '../texture-sampling.ts'

/** Influence of each layer (0..1 in x, y, z, w), and the texture coordinates of the layers' maps, see `SliceSampler`. */
export interface LayerInfluence {
  influence: Node<'vec4'>
  uv: Node<'vec2'>
  sampler: SliceSampler
}

/** Reoriented normal mapping of unit vectors, see `reorientNormal` in the reference. */
export function reorient(base: Node<'vec3'>, detail: Node<'vec3'>): Node<'vec3'> {
  return reorientBy(base, lengthOf(base), detail.xy, detail.z)
}

/**
 * Reoriented normal mapping of vectors of any length. Expands t dot(t, r) / t.z - size r with t = (x, y, z + size) and r = (-slope, depth).
 * A slope of 0 keeps the base's direction without a branch.
 *
 * @param size length of the base.
 * @param slope slope of the detail, times `depth`.
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

/** Length with an epsilon that keeps z + length above 0, cheaper than a clamp. */
function lengthOf(normal: Node<'vec3'>): Node<'float'> {
  return normal.dot(normal).add(1e-6).sqrt()
}

/**
 * Mixes the normals of all layers into the base, see `mixNormals` in the reference.
 *
 * @param base unpacked normal of the material's own map.
 * @returns a normal of any length; in the direction of the base if the influence of all layers is 0.
 */
export function mixNormals(
  base: Node<'vec3'>,
  inputs: ShaderInputs,
  { influence, uv, sampler }: LayerInfluence,
): Node<'vec3'> {
  const { kinds, normals } = inputs.textures
  const scales = inputUniform<'vec4'>(inputs.normalScale)
  const baseNormal = base.toVar()
  const sample = sampler(uv)
  // Slightly below 0.5: a z of exactly 0 gives no normal, or 0 / 0 at an influence of 0.
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
  // A single detail normal needs no division by z, the most expensive operation.
  const isOne = details.length === 1
  const depth = isOne ? details[0].normal.z.abs() : float(1)
  return reorientBy(replaced, size, slopeOf(details, isOne), depth)
}

interface SampledLayer {
  kind: LayerKind
  influence: Node<'float'>
  /** Scale of the normal's x and y. */
  scale: Node<'float'>
  /** Unpacked normal. For a detail layer: stored x and y, unpacked later with their factor, and half of z. */
  normal: Node<'vec3'>
}

function filterByKind(kind: LayerKind, layers: readonly SampledLayer[]): SampledLayer[] {
  return layers.filter((layer) => layer.kind === kind)
}

/** Unpacks a stored normal from 0..1 to -1..1. */
export function unpack(stored: Node<'vec3'>): Node<'vec3'> {
  return stored.mul(2).sub(1)
}

/** Mixes replacing layers into the base by their influences, normalised if their sum exceeds 1. */
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

/** Mixing weights of layers: their influences, divided by the sum if it exceeds 1. The influence of a single layer never does. */
export function sharesOf(influences: readonly Node<'float'>[]): readonly Node<'float'>[] {
  if (influences.length < 2) return influences
  const sum = influences.reduce((total, influence) => total.add(influence))
  const total = max(float(1), sum).toVar()
  return influences.map((influence) => influence.div(total))
}

/**
 * Sums the slopes of detail layers.
 *
 * @param isFlat whether to skip the division by the normal's z.
 */
function slopeOf(layers: readonly SampledLayer[], isFlat: boolean): Node<'vec2'> {
  const slopes = layers.map(({ influence, scale, normal }) => {
    const share = influence.mul(scale)
    const factor = (isFlat ? share : share.div(normal.z)).toVar()
    return normal.xy.mul(factor).sub(factor.mul(0.5))
  })
  return slopes.reduce((total, slope) => total.add(slope)).toVar()
}

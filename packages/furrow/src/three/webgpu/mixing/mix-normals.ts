/** The layers' normals mixed into the material's own, in TSL; the same formulas as the GLSL of `webgl/` and the reference. */
import { float, max, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { LayerKind } from '../../../core/types.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import { CHANNELS, inputUniform } from '../node.ts'
import type { SliceSampler } from '../texture-sampling.ts'

/** The influence of each layer, 0..1 in x, y, z, w, and the texture coordinates to sample the layers' maps at, see `SliceSampler`. */
export interface LayerInfluence {
  influence: Node<'vec4'>
  uv: Node<'vec2'>
  sampler: SliceSampler
}

/** Reoriented normal mapping, see `reorientNormal` in the reference; unit vectors. */
export function reorient(base: Node<'vec3'>, detail: Node<'vec3'>): Node<'vec3'> {
  return reorientBy(base, lengthOf(base), detail.xy, detail.z)
}

/**
 * The same direction, of vectors of any length. With t = (x, y, z + size) and r = (-slope, depth), t dot(t, r) / t.z - size r is multiplied out,
 * so that a slope of 0 leaves the base's direction without a choice between the two.
 *
 * @param size length of the base.
 * @param slope of the detail, times its depth.
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

/** What is added to it keeps the sum of z and the length from 0; a limit would be one step more. */
function lengthOf(normal: Node<'vec3'>): Node<'float'> {
  return normal.dot(normal).add(1e-6).sqrt()
}

/**
 * Mixes the normals of all layers into the base, see `mixNormals` in the reference.
 *
 * @param base of the material's own map, unpacked.
 * @returns of any length, since whoever uses it normalises it; in the direction of the base where the influence of all layers is 0.
 */
export function mixNormals(
  base: Node<'vec3'>,
  inputs: ShaderInputs,
  { influence, uv, sampler }: LayerInfluence,
): Node<'vec3'> {
  const { kinds, normals } = inputs.textures
  const scales = inputUniform<'vec4'>(inputs.normalScale)
  const own = base.toVar()
  const sample = sampler(uv)
  // A z of exactly 0 would leave no normal, or divide an influence of 0 by 0; it never comes out of this.
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
  const replaced = replaceNormal(own, ofKind('replace', layers))
  const details = ofKind('detail', layers)
  if (details.length === 0) return replaced
  const size = lengthOf(replaced).toVar()
  // The normal of a single one need not be divided by its z, which takes the longest.
  const isOne = details.length === 1
  const depth = isOne ? details[0].normal.z.abs() : float(1)
  return reorientBy(replaced, size, slopeOf(details, isOne), depth)
}

interface SampledLayer {
  kind: LayerKind
  influence: Node<'float'>
  /** Of x and y of the normal. */
  scale: Node<'float'>
  /** Of one of detail, x and y as stored, which are unpacked with their factor, and half of z. */
  normal: Node<'vec3'>
}

function ofKind(kind: LayerKind, layers: readonly SampledLayer[]): SampledLayer[] {
  return layers.filter((layer) => layer.kind === kind)
}

/** A normal from what a map stores. */
export function unpack(stored: Node<'vec3'>): Node<'vec3'> {
  return stored.mul(2).sub(1)
}

/** Mixes layers that replace into the base by their influence, normalised where their sum exceeds 1. */
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

/** The shares of layers in what they are mixed into: their influence, and less where its sum exceeds 1, which that of one layer does not. */
export function sharesOf(influences: readonly Node<'float'>[]): readonly Node<'float'>[] {
  if (influences.length < 2) return influences
  const sum = influences.reduce((total, influence) => total.add(influence))
  const total = max(float(1), sum).toVar()
  return influences.map((influence) => influence.div(total))
}

/**
 * The sum of the slopes of layers of detail.
 *
 * @param isFlat whether they are left times the depth of the normal, half of its z.
 */
function slopeOf(layers: readonly SampledLayer[], isFlat: boolean): Node<'vec2'> {
  const slopes = layers.map(({ influence, scale, normal }) => {
    const share = influence.mul(scale)
    const factor = (isFlat ? share : share.div(normal.z)).toVar()
    return normal.xy.mul(factor).sub(factor.mul(0.5))
  })
  return slopes.reduce((total, slope) => total.add(slope)).toVar()
}

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
  return reorientBy(base, float(1), detail.xy, detail.z)
}

/**
 * The same direction, of vectors of any length. With t = (x, y, z + size) and r = (-slope, depth), t dot(t, r) / t.z - size r is multiplied out,
 * so that a slope of 0 at a depth of 1 leaves the base as it is without a choice between the two.
 *
 * @param size length of the base.
 */
function reorientBy(
  base: Node<'vec3'>,
  size: Node<'float'>,
  slope: Node<'vec2'>,
  depth: Node<'float'>,
): Node<'vec3'> {
  const along = base.xy.dot(slope).toVar()
  const shrunk = depth.sub(along.div(base.z.add(size).max(1e-6)))
  return vec3(base.xy.mul(shrunk).add(slope.mul(size)), base.z.mul(depth).sub(along))
}

/**
 * Mixes the normals of all layers into the base, see `mixNormals` in the reference.
 *
 * @param base of the material's own map, unpacked.
 * @param isUnit whether that is of unit length.
 * @returns of any length, since whoever uses it normalises it; the base itself, bit by bit, where the influence of all layers is 0.
 */
export function mixNormals(
  base: Node<'vec3'>,
  inputs: ShaderInputs,
  { influence, uv, sampler }: LayerInfluence,
  isUnit = false,
): Node<'vec3'> {
  const { kinds, normals } = inputs.textures
  const scales = inputUniform<'vec4'>(inputs.normalScale)
  const own = base.toVar()
  const sample = sampler(uv)
  // A z of exactly 0 would divide an influence of 0 by 0.
  const one = vec3(1, 1, 0.9999999)
  const layers = kinds.map((kind, layer) => ({
    kind,
    influence: influence[CHANNELS[layer]],
    scale: scales[CHANNELS[layer]],
    normal: sample(normals.texture, normals.slices[layer]!).xyz.mul(2).sub(one).toVar(),
  }))
  const replacing = ofKind('replace', layers)
  const details = ofKind('detail', layers)
  const replaced = replaceNormal(own, replacing)
  if (details.length === 0) return replaced
  const size = isUnit && replacing.length === 0 ? float(1) : replaced.length().toVar()
  return reorientBy(replaced, size, slopeOf(details), float(1))
}

interface SampledLayer {
  kind: LayerKind
  influence: Node<'float'>
  /** Of x and y of the normal. */
  scale: Node<'float'>
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

/** The sum of the slopes of layers of detail. */
function slopeOf(layers: readonly SampledLayer[]): Node<'vec2'> {
  const slopes = layers.map(({ influence, scale, normal }) =>
    normal.xy.mul(influence.mul(scale).div(normal.z)),
  )
  return slopes.reduce((total, slope) => total.add(slope)).toVar()
}

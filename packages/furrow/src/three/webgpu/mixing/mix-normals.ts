/** The layers' normals mixed into the material's own, in TSL; the same formulas as the GLSL of `webgl/` and the reference. */
import { Fn, float, max, mix, vec2, vec3, vec4 } from 'three/tsl'
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
  return alongReoriented(base, detail).div(base.z.add(1))
}

/**
 * The same direction, from vectors of any length. Of t and r in the reference, the base's length times t.z is left in as a factor, so that
 * nothing is divided.
 */
function alongReoriented(base: Node<'vec3'>, detail: Node<'vec3'>): Node<'vec3'> {
  const size = base.length().toVar()
  const t = vec3(base.xy, base.z.add(size)).toVar()
  const r = detail.mul(vec3(-1, -1, 1)).toVar()
  return t.mul(t.dot(r)).sub(r.mul(size.mul(t.z)))
}

/**
 * Mixes the normals of all layers into the base, see `mixNormals` in the reference.
 *
 * @param base the material's own map as stored, 0..1.
 * @returns normal as stored, but of any length, since whoever uses it normalises it; the base itself, bit by bit, where the influence of
 *   all layers is 0.
 */
export function mixNormals(
  base: Node<'vec3'>,
  inputs: ShaderInputs,
  { influence, uv, sampler }: LayerInfluence,
): Node<'vec3'> {
  const { kinds, normals } = inputs.textures
  const scales = inputUniform<'vec4'>(inputs.normalScale)
  return Fn(() => {
    const normal = base.toVar()
    const influences = influence.toVar()
    const sample = sampler(uv)
    const own = unpack(normal).toVar()
    const layers = kinds.map((kind, layer) => {
      const scale = scales[CHANNELS[layer]]
      const stored = unpack(sample(normals.texture, normals.slices[layer]!).xyz)
      return {
        kind,
        influence: influences[CHANNELS[layer]],
        normal: stored.mul(vec3(scale, scale, 1)).toVar(),
      }
    })
    const replaced = replaceNormal(own, ofKind('replace', layers))
    const details = ofKind('detail', layers)
    const mixed = details.length === 0 ? replaced : addDetails(replaced, details)
    // No select, which TSL makes a branch.
    const hasInfluence = influences.dot(vec4(1)).sign()
    return mix(normal, mixed.mul(0.5).add(0.5), hasInfluence)
  })()
}

interface SampledLayer {
  kind: LayerKind
  influence: Node<'float'>
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
  const total = max(float(1), sum(layers.map(({ influence }) => influence))).toVar()
  const shareOf = (influence: Node<'float'>) => (layers.length === 1 ? influence : influence.div(total))
  return layers.reduce<Node<'vec3'>>(
    (mixed, { influence, normal }) => mixed.add(normal.sub(base).mul(shareOf(influence))),
    base,
  )
}

/** Sums layers of detail as slopes and reorients them onto the normal. */
function addDetails(base: Node<'vec3'>, layers: readonly SampledLayer[]): Node<'vec3'> {
  const slope = layers.reduce<Node<'vec2'>>(
    (total, { influence, normal }) => total.add(normal.xy.mul(influence.div(normal.z))),
    vec2(0),
  )
  return alongReoriented(base, vec3(slope, 1))
}

export function sum(values: readonly Node<'float'>[]): Node<'float'> {
  return values.reduce<Node<'float'>>((total, value) => total.add(value), float(0))
}

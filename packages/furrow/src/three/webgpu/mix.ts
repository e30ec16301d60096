/** The layers' maps mixed into the material's own, in TSL; the same formulas as the GLSL of `webgl/` and the reference. */
import { Fn, float, If, max, vec2, vec3, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { LayerKind } from '../../core/types.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { ValueKind } from '../material/wrinkle-textures.ts'
import { follow, type Gradients, repeat, sampleSlice } from './influence.ts'

/** Channels of a `vec4` in the order of the layers. */
const CHANNELS = ['x', 'y', 'z', 'w'] as const

/** What shows where: the influence of each layer, and the texture coordinates to sample the layers' maps at. */
export interface Shares {
  influence: Node<'vec4'>
  uv: Node<'vec2'>
}

/** Reoriented normal mapping, see `reorientNormal` in the reference; unit vectors. */
export function reorient(base: Node<'vec3'>, detail: Node<'vec3'>): Node<'vec3'> {
  const t = base.add(vec3(0, 0, 1)).toVar()
  const r = detail.mul(vec3(-1, -1, 1)).toVar()
  return t.mul(t.dot(r).div(t.z)).sub(r)
}

/**
 * Mixes the normals of all layers into the base, see `mixNormals` in the reference.
 *
 * @param base the material's own map as stored, 0..1.
 * @returns normal as stored, 0..1; the base itself, bit by bit, where no layer shows.
 */
export function mixNormals(
  base: Node<'vec3'>,
  inputs: ShaderInputs,
  { influence, uv }: Shares,
): Node<'vec3'> {
  const { textures, normalScale } = inputs
  const { kinds, normals } = textures
  const scales = follow<'vec4'>(normalScale)
  return Fn(() => {
    const normal = base.toVar()
    const shares = influence.toVar()
    const at = gradients(uv)
    If(shares.greaterThan(vec4(0)).any(), () => {
      const own = unpack(normal).toVar()
      const layers = kinds.map((kind, layer) => {
        const share = shares[CHANNELS[layer]] as Node<'float'>
        const sampled = (kind === 'replace' ? own : vec3(0, 0, 1)).toVar()
        If(share.greaterThan(0), () => {
          const stored = unpack(sampleSlice(normals.texture, at, normals.slices[layer]!).xyz as Node<'vec3'>)
          const scale = scales[CHANNELS[layer]] as Node<'float'>
          sampled.assign(stored.mul(vec3(scale, scale, 1)))
        })
        return { kind, share, normal: sampled as Node<'vec3'> }
      })
      const replaced = replace(own, of('replace', layers))
      const details = of('detail', layers)
      const mixed = details.length === 0 ? replaced : detail(replaced, details)
      normal.assign(mixed.mul(0.5).add(0.5))
    })
    return normal
  })() as unknown as Node<'vec3'>
}

/**
 * Mixes one kind of the layers' other maps into the material's own value, see `mixValues` in the reference.
 *
 * @param base the value of the material's own map, 1 where it has none; for occlusion and roughness in x.
 */
export function mixValues(
  kind: ValueKind,
  base: Node<'vec3'>,
  { textures, occlusionStrength }: ShaderInputs,
  { influence, uv }: Shares,
): Node<'vec3'> {
  const { texture, slices, channel } = textures.values[kind]!
  const strengths = follow<'vec4'>(occlusionStrength)
  const present = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
  return Fn(() => {
    const own = base.toVar()
    const value = own.toVar()
    const shares = influence.toVar()
    const at = gradients(uv)
    const shareOf = (layer: number) => shares[CHANNELS[layer]] as Node<'float'>
    const total = max(float(1), sum(present.map(({ layer }) => shareOf(layer)))).toVar()
    for (const { slice, layer } of present) {
      If(shareOf(layer).greaterThan(0), () => {
        const texel = sampleSlice(texture, at, slice)
        const stored = kind === 'baseColor' ? texel.rgb : vec3(texel[CHANNELS[channel]] as Node<'float'>)
        const strength = strengths[CHANNELS[layer]] as Node<'float'>
        const wanted = kind === 'occlusion' ? stored.sub(1).mul(strength).add(1) : stored
        value.addAssign(wanted.sub(own).mul(shareOf(layer)).div(total))
      })
    }
    return value
  })() as unknown as Node<'vec3'>
}

interface Share {
  kind: LayerKind
  share: Node<'float'>
  normal: Node<'vec3'>
}

function of(kind: LayerKind, layers: readonly Share[]): Share[] {
  return layers.filter((layer) => layer.kind === kind)
}

/** Taken outside of any branch: inside one, neighbouring pixels may part ways. */
function gradients(uv: Node<'vec2'>): Gradients {
  const at = uv.toVar()
  return {
    uv: repeat(at).toVar() as Node<'vec2'>,
    dx: at.dFdx().toVar() as Node<'vec2'>,
    dy: at.dFdy().toVar() as Node<'vec2'>,
  }
}

function unpack(stored: Node<'vec3'>): Node<'vec3'> {
  return stored.mul(2).sub(1) as Node<'vec3'>
}

/** Mixes layers that replace into the base by their influence, shared out where together they exceed 1. */
function replace(base: Node<'vec3'>, layers: readonly Share[]): Node<'vec3'> {
  if (layers.length === 0) return base
  const total = max(float(1), sum(layers.map(({ share }) => share))).toVar()
  return layers.reduce<Node<'vec3'>>(
    (mixed, { share, normal }) => mixed.add(normal.sub(base).mul(share).div(total)),
    base,
  )
}

/** Adds layers of detail up as slopes and lays them over the normal. */
function detail(base: Node<'vec3'>, layers: readonly Share[]): Node<'vec3'> {
  const slope = layers.reduce<Node<'vec2'>>(
    (total, { share, normal }) => total.add(normal.xy.div(normal.z).mul(share)) as Node<'vec2'>,
    vec2(0),
  )
  return reorient(base.normalize() as Node<'vec3'>, vec3(slope, 1).normalize() as Node<'vec3'>)
}

function sum(values: readonly Node<'float'>[]): Node<'float'> {
  return values.reduce<Node<'float'>>((total, value) => total.add(value), float(0))
}

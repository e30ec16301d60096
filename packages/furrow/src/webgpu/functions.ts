/**
 * The wrinkle functions in TSL, as pure functions of nodes; the same formulas as the GLSL of `webgl/` and the
 * float64 reference of `core/`.
 */
import type { DataArrayTexture, Texture } from 'three'
import {
  Fn,
  float,
  int,
  ivec2,
  Loop,
  max,
  min,
  select,
  texture,
  textureLoad,
  uniform,
  vec2,
  vec3,
  vec4,
} from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { LayerKind } from '../core/types.ts'

/** Channels of a `vec4` in the order of the layers. */
const CHANNELS = ['x', 'y', 'z', 'w'] as const

/** One texel of one layer of an array, filtered; `xyz` as stored, 0..1. */
export function sampleLayer(array: DataArrayTexture, uv: Node<'vec2'>, layer: number): Node<'vec4'> {
  return texture(array, uv).depth(int(layer)) as unknown as Node<'vec4'>
}

/**
 * How much of each layer shows at a point: the paper's step 3, for every layer at once.
 *
 * @param areas one channel, one array layer per area.
 * @param activations table of `Activations`: row 0 adds up, row 1 takes the largest.
 * @param count number of areas, a uniform, so that no program depends on it.
 * @returns influence of layers 0..3 in x, y, z, w, each 0..1.
 */
export function influence(
  areas: DataArrayTexture,
  activations: Texture,
  count: Node<'int'>,
  uv: Node<'vec2'>,
): Node<'vec4'> {
  return Fn(() => {
    const added = vec4(0).toVar()
    const largest = vec4(0).toVar()
    Loop({ start: int(0), end: count, type: 'int', condition: '<' }, ({ i: index }) => {
      const i = index as unknown as Node<'int'>
      const weight = (texture(areas, uv).depth(i).level(int(0)) as unknown as Node<'vec4'>).x.toVar()
      added.addAssign(textureLoad(activations, ivec2(i, int(0))).mul(weight))
      largest.assign(max(largest, textureLoad(activations, ivec2(i, int(1))).mul(weight)))
    })
    return max(min(added, vec4(1)), largest)
  })() as unknown as Node<'vec4'>
}

/** The number of areas as a uniform that follows `count.value`. */
export function areaCount(count: { readonly value: number }): Node<'int'> {
  return uniform(count.value, 'int').onObjectUpdate(() => count.value) as unknown as Node<'int'>
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
 * @param shares influence of each layer, from `influence`.
 * @returns normal as stored, 0..1; the base itself, bit by bit, where no layer shows.
 */
export function mixNormals(
  base: Node<'vec3'>,
  normals: DataArrayTexture,
  kinds: readonly LayerKind[],
  shares: Node<'vec4'>,
  uv: Node<'vec2'>,
): Node<'vec3'> {
  return Fn(() => {
    // Sampled before any branch: inside one, neighbouring pixels may part ways and the mip level is undefined.
    const own = base.toVar()
    const layers = kinds.map((kind, layer) => ({
      kind,
      share: shares[CHANNELS[layer]] as Node<'float'>,
      normal: (sampleLayer(normals, uv, layer).xyz as Node<'vec3'>).toVar(),
    }))
    const replaced = replace(
      own,
      layers.filter(({ kind }) => kind === 'replace'),
    )
    const details = layers.filter(({ kind }) => kind === 'detail')
    if (details.length === 0) return replaced
    const flat = replaced.toVar()
    const showing = details.reduce<Node<'float'>>((sum, { share }) => sum.add(share), float(0))
    const slope = details.reduce<Node<'vec2'>>((sum, { share, normal }) => {
      const unpacked = normal.mul(2).sub(1)
      return sum.add(unpacked.xy.div(unpacked.z).mul(share)) as Node<'vec2'>
    }, vec2(0))
    const reoriented = reorient(flat.mul(2).sub(1).normalize(), vec3(slope, 1).normalize())
    return select(showing.greaterThan(0), reoriented.mul(0.5).add(0.5), flat)
  })() as unknown as Node<'vec3'>
}

/** Mixes layers that replace into the base by their influence, shared out where together they exceed 1. */
function replace(
  base: Node<'vec3'>,
  layers: readonly { share: Node<'float'>; normal: Node<'vec3'> }[],
): Node<'vec3'> {
  const total = max(
    float(1),
    layers.reduce<Node<'float'>>((sum, { share }) => sum.add(share), float(0)),
  )
  return layers.reduce<Node<'vec3'>>(
    (sum, { share, normal }) => sum.add(normal.sub(base).mul(share).div(total)),
    base,
  )
}

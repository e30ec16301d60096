/** How much of each layer shows at a point, in TSL; the same formulas as the GLSL of `webgl/`. */
import { Matrix3, type Texture } from 'three'
import {
  drawIndex,
  Fn,
  float,
  If,
  instanceIndex,
  int,
  ivec2,
  Loop,
  max,
  min,
  texture,
  textureLoad,
  textureSize,
  uniform,
  uv,
  varying,
  vec2,
  vec3,
  vec4,
} from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { Instances } from '../instances.ts'
import type { ArrayTexture } from '../loader/texture-arrays.ts'
import type { ActivationTable } from '../material/activation-table.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { WrinkleMaterial } from '../material/wrinkle-material.ts'

/** A uniform that follows what an input's `value` is when an object is drawn. */
export function follow<T extends string>(input: { readonly value: unknown }): Node<T> {
  return uniform(input.value as never).onObjectUpdate(() => input.value as never) as unknown as Node<T>
}

/**
 * From the atlas of influence maps: one sample, however many areas there are.
 *
 * @param instances of the mesh, each of which has a cell of its own.
 * @returns influence of layers 0..3 in x, y, z, w, each 0..1.
 */
export function influenceFromMap(
  inputs: ShaderInputs,
  place: Node<'vec2'>,
  instances: Instances,
): Node<'vec4'> {
  const grid = follow<'vec3'>(inputs.grid)
  const inset = follow<'vec2'>(inputs.inset)
  const reach = follow<'vec4'>(inputs.reach)
  const fade = follow<'float'>(inputs.fade)
  const layers = inputs.textures.layers.length
  return Fn(() => {
    const shares = vec4(0).toVar()
    const uv = repeat(place).toVar() as Node<'vec2'>
    const isReached = uv
      .greaterThanEqual(reach.xy as never)
      .all()
      .and(uv.lessThanEqual(reach.zw as never).all())
    If(fade.greaterThan(0).and(isReached as never), () => {
      const first = grid.z
      const index = instances ? first.add(varying(instanceOf(instances))) : first
      const row = index.add(0.5).div(grid.x).floor().toVar()
      const corner = vec2(index.sub(row.mul(grid.x)) as Node<'float'>, row)
      const inside = uv.clamp(inset, inset.oneMinus()) as Node<'vec2'>
      const texel = corner.add(inside).div(grid.xy) as Node<'vec2'>
      const sampled = texture(inputs.influence.value, texel).level(int(0)) as unknown as Node<'vec4'>
      // Channels without a layer hold whatever the format gives them.
      const used = vec4(
        ...([0, 1, 2, 3].map((i) => (i < layers ? 1 : 0)) as [number, number, number, number]),
      )
      shares.assign(min(sampled, vec4(1)).mul(fade).mul(used))
    })
    return shares
  })() as unknown as Node<'vec4'>
}

/** Number of the instance that is drawn. A batch draws what it shows in an order of its own, which is in a texture. */
function instanceOf(instances: 'instanced' | 'batched'): Node<'float'> {
  if (instances === 'instanced') return float(instanceIndex) as unknown as Node<'float'>
  return (Fn as unknown as FnOfBuilder)((_, builder) => {
    const drawn = int((builder.getDrawIndex() === null ? instanceIndex : drawIndex) as never)
    const order = builder.object._indirectTexture
    const { width } = order.image as { width: number }
    const place = ivec2(drawn.mod(int(width)) as never, drawn.div(int(width)) as never)
    return float(textureLoad(order, place).x as never)
  })() as Node<'float'>
}

/** What the types leave out. */
type FnOfBuilder = (build: (inputs: unknown, builder: Builder) => unknown) => () => unknown

interface Builder {
  object: { _indirectTexture: Texture }
  getDrawIndex(): string | null
}

/**
 * From the areas themselves, as in the paper's step 3: a loop over all of them, for every layer at once.
 *
 * @param table says which activations belong to which slice and channel.
 */
export function influenceFromAreas(
  { areas }: ShaderInputs,
  table: ActivationTable,
  place: Node<'vec2'>,
): Node<'vec4'> {
  const count = uniform(table.count.value, 'int').onObjectUpdate(
    () => table.count.value,
  ) as unknown as Node<'int'>
  return Fn(() => {
    const added = vec4(0).toVar()
    const largest = vec4(0).toVar()
    const uv = repeat(place).toVar() as Node<'vec2'>
    Loop({ start: int(0), end: count, type: 'int', condition: '<' }, ({ i: index }) => {
      const i = index as unknown as Node<'int'>
      const slice = areas.channels === 1 ? i : (i.div(int(4)) as Node<'int'>)
      const texel = texture(areas.texture, uv).depth(slice).level(int(0)) as unknown as Node<'vec4'>
      const weight = (areas.channels === 1 ? texel.x : texel.dot(channelMask(float(i.mod(int(4)))))).toVar()
      added.addAssign(textureLoad(table.texture, ivec2(i, int(0))).mul(weight))
      largest.assign(max(largest, textureLoad(table.texture, ivec2(i, int(1))).mul(weight)))
    })
    return max(min(added, vec4(1)), largest)
  })() as unknown as Node<'vec4'>
}

/** 1 in the channel of that number, 0 in the others. */
export function channelMask(channel: Node<'float'>): Node<'vec4'> {
  return vec4(0, 1, 2, 3).sub(channel).abs().oneMinus().clamp(0, 1) as unknown as Node<'vec4'>
}

/**
 * One texel of one slice of an array, filtered by the gradients of the coordinates: safe inside a branch. Only an anisotropic
 * sampler needs the gradients themselves, which cost more than the level they come to (OpenGL ES 3.0, equations 3.18 and 3.21).
 */
export function sampleSlice(array: ArrayTexture, { uv, dx, dy }: Gradients, slice: number): Node<'vec4'> {
  const sampled = texture(array, uv).depth(int(slice)) as unknown as Sampled
  if (array.anisotropy > 1) return sampled.grad(dx, dy)
  const size = vec2(textureSize(texture(array), int(0)) as never) as unknown as Node<'vec2'>
  const [across, down] = [dx.mul(size), dy.mul(size)] as [Node<'vec2'>, Node<'vec2'>]
  const level = max(across.dot(across), down.dot(down), 1).log2().mul(0.5)
  return sampled.level(level)
}

/** What the types leave out. */
interface Sampled {
  grad(x: Node, y: Node): Node<'vec4'>
  level(level: Node): Node<'vec4'>
}

/** Texture coordinates outside 0..1 less their whole numbers, see `repeat` in core; those within are left exactly as they are. */
export function repeat(uv: Node<'vec2'>): Node<'vec2'> {
  return uv.sub(max(uv.ceil().sub(1), min(uv.floor(), 0))) as Node<'vec2'>
}

/** UV of the material's normal map, its `KHR_texture_transform` applied. */
export function mapUv(material: WrinkleMaterial): Node<'vec2'> {
  const transform = uniform(new Matrix3()).onObjectUpdate(() => {
    const map = material.normalMap!
    if (map.matrixAutoUpdate) map.updateMatrix()
    return map.matrix
  })
  return transform.mul(vec3(uv(material.normalMap!.channel), 1)).xy as Node<'vec2'>
}

/** Texture coordinates and how they change from pixel to pixel. */
export interface Gradients {
  uv: Node<'vec2'>
  dx: Node<'vec2'>
  dy: Node<'vec2'>
}

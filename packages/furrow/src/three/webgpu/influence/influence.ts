/** TSL that samples the influence map of a face. The formulas are those of the GLSL in `webgl/`. */
import { REVISION, type Texture } from 'three'
import {
  drawIndex,
  Fn,
  float,
  If,
  instanceIndex,
  int,
  ivec2,
  min,
  texture,
  textureLoad,
  varying,
  vec2,
  vec4,
} from 'three/tsl'
import { type Node, NodeBuilder } from 'three/webgpu'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import type { Instances } from '../../mesh/instances.ts'
import { requireInternal } from '../../three-version.ts'
import { CHANNELS, inputUniform } from '../node.ts'

/**
 * Samples the influence map of a face. The map holds, per layer, how strongly the layer is visible. Maps of several faces are cells of one
 * texture, the influence atlas. Fragment shaders have no branch here, because on software rasterisers a branch costs more than the sample that
 * it would save.
 *
 * @param uv texture coordinates within 0..1, see `repeat`.
 * @param instances kind of instancing. Each instance has a separate cell.
 * @param isVertex whether the result is for a vertex shader. The shader then takes no sample outside the bounds of active areas.
 * @param isOnly whether the cell of this face fills the atlas.
 * @returns influence of layers 0..3 in x, y, z, w, each 0..1.
 */
export function influenceFromMap(
  inputs: ShaderInputs,
  uv: Node<'vec2'>,
  instances: Instances,
  isVertex = false,
  isOnly = false,
): Node<'vec4'> {
  const cell = inputUniform<'vec4'>(inputs.cell)
  const { xy: factor, zw: offset } = inputUniform<'vec4'>(inputs.inside)
  const fade = inputUniform<'float'>(inputs.fade)
  const layers = inputs.textures.layers.length
  const place = () => {
    const corner = instances ? varying(cornerOf(inputs, instanceOf(instances))) : cell.xy
    return corner.add(uv.mul(factor).add(offset).saturate().mul(cell.zw))
  }
  const sample = () => {
    const atlas = texture(inputs.influence.value, isOnly ? uv : place())
    const sampled = isVertex ? atlas.level(int(0)) : atlas
    // The values of channels without a layer are undefined.
    const [x, y, z, w] = CHANNELS.map((channel, i) => (i < layers ? sampled[channel] : float(0)))
    return min(vec4(x, y, z, w), vec4(1)).mul(fade)
  }
  if (!isVertex) return sample().toVar()
  return Fn(() => {
    const influence = vec4(0).toVar()
    If(isWithin(uv, inputUniform<'vec4'>(inputs.reach)), () => {
      influence.assign(sample())
    })
    return influence
  })()
}

/** Whether texture coordinates are within bounds: u0, v0, u1, v1. */
function isWithin(uv: Node<'vec2'>, bounds: Node<'vec4'>): Node<'bool'> {
  return uv.greaterThanEqual(bounds.xy).all().and(uv.lessThanEqual(bounds.zw).all())
}

/** Returns the centre of the first texel of an instance's cell, in atlas coordinates (0..1). Instances have consecutive cells, row by row. */
function cornerOf({ grid, inset }: ShaderInputs, instance: Node<'float'>): Node<'vec2'> {
  const { x: columns, xy: size, z: first } = inputUniform<'vec3'>(grid)
  const cell = first.add(instance)
  const row = cell.add(0.5).div(columns).floor()
  return vec2(cell.sub(row.mul(columns)), row)
    .add(inputUniform<'vec2'>(inset))
    .div(size)
}

/** Returns the index of the drawn instance. A `BatchedMesh` reorders its visible instances, and stores their order in a texture. */
function instanceOf(instances: 'instanced' | 'batched'): Node<'float'> {
  if (instances === 'instanced') return float(instanceIndex)
  return Fn((_: [], builder: NodeBuilder) => {
    const { object, getDrawIndex } = builder as BatchBuilder
    const drawn = int(getDrawIndex.call(builder) === null ? instanceIndex : drawIndex)
    const order = object._indirectTexture
    const { width } = order.image as { width: number }
    const texel = ivec2(drawn.mod(int(width)), drawn.div(int(width)))
    return float(textureLoad(order, texel).x)
  })()
}

/** Builder of the shader of a `BatchedMesh`, with undocumented internals of three.js that `checkBatch` checks. */
type BatchBuilder = NodeBuilder & {
  object: { _indirectTexture: Texture }
  getDrawIndex(): string | null
}

/** @throws FurrowError if three.js lacks an internal property that `influenceFromMap` needs for a `BatchedMesh`. */
export function checkBatch(mesh: object): void {
  requireInternal(
    (mesh as BatchBuilder['object'])._indirectTexture,
    'Wrinkles',
    'BatchedMesh._indirectTexture',
    REVISION,
  )
  requireInternal(
    (NodeBuilder.prototype as BatchBuilder).getDrawIndex,
    'Wrinkles',
    'NodeBuilder.getDrawIndex',
    REVISION,
  )
}

/** Returns a vector with 1 in the given channel (0..3), and 0 in the other channels. */
export function channelMask(channel: Node<'float'>): Node<'vec4'> {
  return vec4(0, 1, 2, 3).sub(channel).abs().oneMinus().clamp(0, 1)
}

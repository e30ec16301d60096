/** A vertex of a dense geometry, in TSL; the same formulas as the GLSL of `webgl/` and `displace` of the room `relief`. */
import type { BufferGeometry, Texture } from 'three'
import {
  attribute,
  Fn,
  If,
  instancedMesh,
  int,
  ivec2,
  Loop,
  min,
  normalLocal,
  positionLocal,
  select,
  tangentLocal,
  texture,
  textureLoad,
  vec3,
} from 'three/tsl'
import type { Node, NodeBuilder } from 'three/webgpu'
import { CANCELLED, PHONG, ROOM_TO_CURVE } from '../../relief/displaced.ts'
import type { Instances } from '../instances.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import { COARSE_WIDTH } from '../relief/coarse-pass.ts'
import type { ReliefInputs } from '../relief/relief-inputs.ts'
import { influenceFromMap } from './influence.ts'
import { inputUniform, typed } from './node.ts'
import { fromOctahedron } from './octahedron.ts'
import { repeat } from './texture-sampling.ts'

/** Vertices at one position at most whose normals are averaged: a guard, not a limit that meshes meet. */
const MOST_TWINS = 16

const CHANNELS = ['x', 'y', 'z', 'w'] as const

/**
 * For `positionNode`, which shadows and other passes use too: the place of a vertex of a dense geometry, whose normal and tangent are set as
 * well. Any other geometry is drawn as before.
 *
 * @param own the material's own `positionNode`, which then moves the surface further.
 */
export function reliefPosition(
  relief: ReliefInputs,
  inputs: ShaderInputs,
  instances: Instances,
  own: Node<'vec3'> | null,
): Node<'vec3'> {
  return Fn((_: [], { geometry, object }: NodeBuilder & { geometry: BufferGeometry }) => {
    if (!geometry.hasAttribute('furrowWeights')) return own ?? positionLocal
    const { directions } = relief.coarse
    normalLocal.assign(mixCorners((vertex) => normalOf(directions, vertex)))
    if (geometry.hasAttribute('tangent'))
      tangentLocal.assign(mixCorners((vertex) => tangentOf(directions, vertex)))
    positionLocal.assign(surface(relief, inputs, instances))
    // three.js has moved the instances already: vertices that were not in their places then.
    if (instances) instancedMesh(object as never)
    return own ?? positionLocal
  })()
}

function mixCorners(direction: (vertex: Node<'float'>) => Node<'vec3'>): Node<'vec3'> {
  const corners = attribute<'vec3'>('furrowCorners', 'vec3')
  const weights = attribute<'vec3'>('furrowWeights', 'vec3')
  return mixThree(
    (axis) => {
      const own = vec3(0).toVar()
      If(weights[axis].greaterThan(0), () => {
        own.assign(direction(corners[axis]))
      })
      return own
    },
    (axis) => weights[axis],
  )
}

function normalOf(directions: Texture, vertex: Node<'float'>): Node<'vec3'> {
  return fromOctahedron(coarseTexel(directions, vertex).xy)
}

function tangentOf(directions: Texture, vertex: Node<'float'>): Node<'vec3'> {
  return fromOctahedron(coarseTexel(directions, vertex).zw)
}

function surface(
  { heights, coarse, unitsPerMetre, amount }: ReliefInputs,
  inputs: ShaderInputs,
  instances: Instances,
): Node<'vec3'> {
  const parents = attribute<'vec3'>('furrowParents', 'vec3')
  const weights = attribute<'vec3'>('furrowWeights', 'vec3')
  const uvs = attribute<'vec4'>('furrowUvs', 'vec4')
  const room = attribute<'float'>('furrowRoom', 'float')
  const amountNow = inputUniform<'float'>(amount)
  const weightOf = (axis: Axis) => weights[axis]
  const points = { x: vertexOf('x'), y: vertexOf('y'), z: vertexOf('z') }

  function vertexOf(axis: Axis) {
    const [position, normal] = [vec3(0).toVar(), vec3(0).toVar()]
    // Most vertices are the mesh's own, or on an edge.
    If(weights[axis].greaterThan(0), () => {
      const texel = coarseTexel(coarse.positions, parents[axis]).toVar()
      position.assign(texel.xyz)
      normal.assign(smoothNormal(coarse, parents[axis], texel.w))
    })
    return { position, normal }
  }

  function displacement(at: Node<'vec2'>): Node<'float'> {
    const influence = influenceFromMap(inputs, at, instances).toVar()
    const uv = repeat(at).toVar()
    const moved = heights.layers.map(({ layer, slice, amplitude }) => {
      const height = texture(heights.texture, uv).depth(int(slice)).level(int(0))[CHANNELS[heights.channel]]
      return influence[CHANNELS[layer]].mul(height.sub(0.5)).mul(amplitude)
    })
    return moved.reduce((sum, own) => sum.add(own))
  }

  const flat = mixThree((axis) => points[axis].position, weightOf).toVar()
  const curve = mixThree((axis) => {
    const { position, normal } = points[axis]
    return normal.mul(flat.sub(position).dot(normal))
  }, weightOf)
  const curved = amountNow.mul(PHONG).mul(min(room.div(ROOM_TO_CURVE), 1))
  const height = displacement(uvs.xy).toVar()
  If(uvs.x.notEqual(uvs.z).or(uvs.y.notEqual(uvs.w)), () => {
    height.assign(height.add(displacement(uvs.zw)).mul(0.5))
  })
  const direction = mixThree((axis) => points[axis].normal, weightOf).normalize()
  const outwards = height.clamp(room.negate(), room).mul(amountNow).mul(unitsPerMetre)
  return flat.sub(curve.mul(curved)).add(direction.mul(outwards))
}

type Axis = 'x' | 'y' | 'z'

function mixThree(value: (axis: Axis) => Node<'vec3'>, weight: (axis: Axis) => Node<'float'>): Node<'vec3'> {
  return value('x')
    .mul(weight('x'))
    .add(value('y').mul(weight('y')), value('z').mul(weight('z')))
}

/** The mean of the normals at a vertex's position: those of the vertices in a ring that begins with it. */
function smoothNormal(
  { positions, directions }: ReliefInputs['coarse'],
  first: Node<'float'>,
  second: Node<'float'>,
): Node<'vec3'> {
  const own = normalOf(directions, first).toVar()
  const sum = own.toVar()
  const next = second.toVar()
  Loop(MOST_TWINS, () => {
    If(next.notEqual(first), () => {
      sum.addAssign(normalOf(directions, next))
      next.assign(coarseTexel(positions, next).w)
    })
  })
  return vec3(select(sum.dot(sum).greaterThan(CANCELLED ** 2), sum, own))
    .normalize()
    .toVar()
}

function coarseTexel(values: Texture, vertex: Node<'float'>): Node<'vec4'> {
  const i = int(vertex).toVar()
  return typed(textureLoad(values, ivec2(i.mod(int(COARSE_WIDTH)), i.div(int(COARSE_WIDTH)))))
}

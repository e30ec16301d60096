/** Vertex of a dense geometry in TSL; same formulas as the GLSL in `webgl/` and `displace` in src/relief. */
import type { BufferGeometry, Texture } from 'three'
import {
  attribute,
  Break,
  Fn,
  If,
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
  vec4,
} from 'three/tsl'
import type { Node, NodeBuilder } from 'three/webgpu'
import { CANCELLED, PHONG, ROOM_TO_CURVE } from '../../../relief/displaced.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import type { Instances } from '../../mesh/instances.ts'
import { COARSE_WIDTH } from '../../relief/coarse-pass.ts'
import type { ReliefInputs } from '../../relief/relief-inputs.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { instancedMesh } from '../newer-nodes.ts'
import { inputUniform, typed } from '../node.ts'
import { repeat } from '../texture-sampling.ts'
import { fromOctahedron } from './octahedron.ts'

/** Maximum number of vertices at one position whose normals are averaged. A loop guard that real meshes do not reach. */
const MAX_TWINS = 16

const CHANNELS = ['x', 'y', 'z', 'w'] as const

/**
 * Creates the `positionNode` of dense geometries, which shadows and other passes use too. Also sets normal and tangent. Other geometries are
 * unaffected.
 *
 * @param ownPosition the material's own `positionNode`, applied afterwards.
 */
export function reliefPosition(
  relief: ReliefInputs,
  inputs: ShaderInputs,
  instances: Instances,
  ownPosition: Node<'vec3'> | null,
): Node<'vec3'> {
  return Fn((_: [], { geometry, object }: NodeBuilder & { geometry: BufferGeometry }) => {
    if (!geometry.hasAttribute('furrowWeights')) return ownPosition ?? positionLocal
    const weights = attribute<'vec3'>('furrowWeights', 'vec3')
    const corners = { x: cornerOf('x'), y: cornerOf('y'), z: cornerOf('z') }

    function cornerOf(axis: Axis): Corner {
      const [position, normal] = [vec3(0).toVar(), vec3(0).toVar()]
      const directions = vec4(0).toVar()
      // Skips unused corners: most vertices coincide with a vertex of the mesh or lie on an edge.
      If(weights[axis].greaterThan(0), () => {
        const corner = attribute<'vec3'>('furrowCorners', 'vec3')[axis]
        directions.assign(coarseTexel(relief.coarse.directions, corner))
        readParent(relief.coarse, axis, directions.xy, position, normal)
      })
      return { position, normal, directions }
    }

    normalLocal.assign(mixThree((axis) => fromOctahedron(corners[axis].directions.xy), weights))
    if (geometry.hasAttribute('tangent'))
      tangentLocal.assign(mixThree((axis) => fromOctahedron(corners[axis].directions.zw), weights))
    positionLocal.assign(surface(relief, inputs, instances, corners))
    // three.js applied the instance matrix before the position was replaced; apply it again.
    if (instances) instancedMesh(object as never)
    return ownPosition ?? positionLocal
  })()
}

/** Coarse vertex of the triangle that contains a dense vertex. `directions` are for shading. */
interface Corner {
  position: Node<'vec3'>
  /** Smooth normal. */
  normal: Node<'vec3'>
  directions: Node<'vec4'>
}

/** Reads position and smooth normal of a parent. Off seams the smooth normal is the corner's. */
function readParent(
  { positions, directions }: ReliefInputs['coarse'],
  axis: Axis,
  direction: Node<'vec2'>,
  position: Node<'vec3'>,
  normal: Node<'vec3'>,
): void {
  const first = attribute<'vec3'>('furrowParents', 'vec3')[axis]
  const corner = attribute<'vec3'>('furrowCorners', 'vec3')[axis]
  const texel = coarseTexel(positions, first).toVar()
  position.assign(texel.xyz)
  normal.assign(fromOctahedron(direction))
  const next = texel.w.toVar()
  If(next.notEqual(first), () => {
    If(corner.notEqual(first), () => {
      normal.assign(normalOf(directions, first))
    })
    const sum = normal.toVar()
    Loop(MAX_TWINS, () => {
      If(next.equal(first), () => {
        Break()
      })
      sum.addAssign(normalOf(directions, next))
      next.assign(coarseTexel(positions, next).w)
    })
    normal.assign(select(sum.dot(sum).greaterThan(CANCELLED ** 2), sum, normal).normalize())
  })
}

function surface(
  { heights, unitsPerMetre, amount }: ReliefInputs,
  inputs: ShaderInputs,
  instances: Instances,
  corners: Record<Axis, Corner>,
): Node<'vec3'> {
  const weights = attribute<'vec3'>('furrowWeights', 'vec3')
  const uvs = attribute<'vec4'>('furrowUvs', 'vec4')
  const room = attribute<'float'>('furrowRoom', 'float')
  const level = attribute<'float'>('furrowLevel', 'float')
  const amountNow = inputUniform<'float'>(amount)

  function displacement(at: Node<'vec2'>): Node<'float'> {
    const uv = repeat(at).toVar()
    const influence = influenceFromMap(inputs, uv, instances, true).toVar()
    const moved = heights.layers.map(({ layer, slice, amplitude }) => {
      const height = texture(heights.texture, uv).depth(int(slice)).level(level)[CHANNELS[heights.channel]]
      return influence[CHANNELS[layer]].mul(height.sub(0.5)).mul(amplitude)
    })
    return moved.reduce((sum, value) => sum.add(value))
  }

  const flat = mixThree((axis) => corners[axis].position, weights).toVar()
  const curve = mixThree((axis) => {
    const { position, normal } = corners[axis]
    return normal.mul(flat.sub(position).dot(normal))
  }, weights)
  const curved = amountNow.mul(PHONG).mul(min(room.div(ROOM_TO_CURVE), 1))
  const height = displacement(uvs.xy).toVar()
  If(uvs.x.notEqual(uvs.z).or(uvs.y.notEqual(uvs.w)), () => {
    height.assign(height.add(displacement(uvs.zw)).mul(0.5))
  })
  const direction = mixThree((axis) => corners[axis].normal, weights).normalize()
  const outwards = height.clamp(room.negate(), room).mul(amountNow).mul(unitsPerMetre)
  return flat.sub(curve.mul(curved)).add(direction.mul(outwards))
}

type Axis = 'x' | 'y' | 'z'

function mixThree(value: (axis: Axis) => Node<'vec3'>, weights: Node<'vec3'>): Node<'vec3'> {
  return value('x').mul(weights.x).add(value('y').mul(weights.y), value('z').mul(weights.z))
}

function normalOf(directions: Texture, vertex: Node<'float'>): Node<'vec3'> {
  return fromOctahedron(coarseTexel(directions, vertex).xy)
}

function coarseTexel(values: Texture, vertex: Node<'float'>): Node<'vec4'> {
  const i = int(vertex).toVar()
  return typed(textureLoad(values, ivec2(i.mod(int(COARSE_WIDTH)), i.div(int(COARSE_WIDTH)))))
}

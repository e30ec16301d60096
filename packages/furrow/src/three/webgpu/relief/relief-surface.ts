/**
 * TSL that places the vertices of a dense geometry, i.e. a geometry with split triangles, on the deformed triangles of the original mesh, and
 * displaces them by height maps. The formulas are those of the GLSL in `webgl/`, and of the reference implementation `displace` in src/relief.
 */
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
import { CANCELLED, CLEARANCE_TO_CURVE, PHONG } from '../../../relief/displaced.ts'
import type { ShaderInputs } from '../../material/shader-inputs.ts'
import type { Instances } from '../../mesh/instances.ts'
import { COARSE_WIDTH } from '../../relief/coarse-pass.ts'
import { onsetLevels, type ReliefInputs } from '../../relief/relief-inputs.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { delayInfluence } from '../mixing/onset.ts'
import { instancedMesh } from '../newer-nodes.ts'
import { inputUniform, typed } from '../node.ts'
import { repeat } from '../texture-sampling.ts'
import { fromOctahedron } from './octahedron.ts'

/** Maximum number of normals that are averaged at one position. It limits a loop in the shader; real meshes have fewer normals there. */
const MAX_TWINS = 16

const CHANNELS = ['x', 'y', 'z', 'w'] as const

/**
 * Creates a `positionNode` that places the vertices of dense geometries, and sets their normals and tangents. Other geometries stay unchanged.
 * Shadows and other passes use the `positionNode` too.
 *
 * @param ownPosition original `positionNode` of the material, or null. When `ownPosition` runs, `positionLocal` is the displaced position.
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
      // Corners with weight 0 are skipped. Most vertices have such a corner, because they are at a vertex or on an edge of the original mesh.
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
    // three.js applied the instance matrix to the position that this function replaced, so the matrix must be applied again.
    if (instances) instancedMesh(object as never)
    return ownPosition ?? positionLocal
  })()
}

/** A corner of the original triangle that contains a dense vertex. */
interface Corner {
  position: Node<'vec3'>
  /** Mean of the normals of all vertices at the position. */
  normal: Node<'vec3'>
  /** Encoded normal (xy) and tangent (zw) for shading. */
  directions: Node<'vec4'>
}

/**
 * Reads the position of a corner of the original triangle, and the mean of the normals of all vertices at this position.
 *
 * @param direction encoded normal of the corner.
 */
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
  relief: ReliefInputs,
  inputs: ShaderInputs,
  instances: Instances,
  corners: Record<Axis, Corner>,
): Node<'vec3'> {
  const { heights, unitsPerMetre, amount } = relief
  const weights = attribute<'vec3'>('furrowWeights', 'vec3')
  const uvs = attribute<'vec4'>('furrowUvs', 'vec4')
  const clearance = attribute<'float'>('furrowClearance', 'float')
  const level = attribute<'float'>('furrowLevel', 'float')
  const amountNow = inputUniform<'float'>(amount)
  const onsetLevel = level.add(onsetLevels(inputs, relief)).max(0)

  function displacement(at: Node<'vec2'>): Node<'float'> {
    const uv = repeat(at).toVar()
    const influence = delayInfluence(
      inputs,
      influenceFromMap(inputs, uv, instances, true).toVar(),
      (onset, slice) => texture(onset, uv).depth(int(slice)).level(onsetLevel),
    )
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
  const curved = amountNow.mul(PHONG).mul(min(clearance.div(CLEARANCE_TO_CURVE), 1))
  const height = displacement(uvs.xy).toVar()
  If(uvs.x.notEqual(uvs.z).or(uvs.y.notEqual(uvs.w)), () => {
    height.assign(height.add(displacement(uvs.zw)).mul(0.5))
  })
  const direction = mixThree((axis) => corners[axis].normal, weights).normalize()
  const outwards = height.clamp(clearance.negate(), clearance).mul(amountNow).mul(unitsPerMetre)
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

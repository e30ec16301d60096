import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type SkinnedMesh,
} from 'three'
import { Loop, storage, uint, vec3, vec4 } from 'three/tsl'
import type { ComputeNode, Node, StorageBufferNode } from 'three/webgpu'
import { coordinates, takeNumbers, targetOffsets } from '../sources/geometry-arrays.ts'
import { at, Buffers, padded, passOver } from './buffers.ts'

/**
 * Where a mesh's vertices are, computed on the graphics card from the positions in its geometry: moved by its blendshapes and, if
 * wanted, its skeleton. Each vertex walks the list of the targets that move it, so that memory and time go by what moves.
 */
export class DeformedPositions {
  /** Of all vertices, in the mesh's own space: x, y and z of each element. */
  readonly node: StorageBufferNode<'vec4'>
  /** What brings `node` up to date, one after the other. */
  readonly passes: readonly ComputeNode[]
  readonly #buffers = new Buffers()
  readonly #inputs: readonly { take(): boolean }[]

  /** @param skinned whether the skeleton moves them too. */
  constructor(mesh: Mesh, skinned: boolean) {
    const { position } = mesh.geometry.attributes
    const rest = isComputed(position)
      ? { node: sharedBuffer(position), take: () => true }
      : this.#copyOf(mesh.geometry)
    const own = () => this.#buffers.create('vec4', new Float32Array(4 * position.count))
    const morphed = morphing(mesh, rest.node, this.#buffers, own)
    const bent = skinned ? skinning(mesh, morphed?.node ?? rest.node, this.#buffers, own) : null
    const steps = [morphed, bent].filter((step) => step !== null)
    this.node = bent?.node ?? morphed?.node ?? rest.node
    this.passes = steps.map(({ pass }) => pass)
    this.#inputs = [rest, ...steps]
  }

  /** Takes positions, weights and joints as they are now; tells whether any may have changed. */
  take(): boolean {
    let changed = false
    for (const input of this.#inputs) if (input.take()) changed = true
    return changed
  }

  dispose(): void {
    for (const pass of this.passes) pass.dispose()
    this.#buffers.dispose()
  }

  /** The positions in the geometry, written anew where they change. */
  #copyOf(geometry: BufferGeometry) {
    const node = this.#buffers.create('vec4', padded(coordinates(geometry.attributes.position)))
    let version = -1
    return {
      node,
      take() {
        const { position } = geometry.attributes
        if (versionOf(position) === version) return false
        if (version >= 0) padded(coordinates(position), node.value.array as Float32Array<ArrayBuffer>)
        version = versionOf(position)
        node.value.needsUpdate = true
        return true
      },
    }
  }
}

/** A step from positions to positions, and what it reads. */
interface Step {
  node: StorageBufferNode<'vec4'>
  pass: ComputeNode
  take(): boolean
}

/** Adds the targets, each times its weight; null where there is none that moves anything. */
function morphing(
  mesh: Mesh,
  from: StorageBufferNode<'vec4'>,
  buffers: Buffers,
  create: () => StorageBufferNode<'vec4'>,
): Step | null {
  const targets = targetOffsets(mesh.geometry)
  const { position } = mesh.geometry.attributes
  const { starts, entries } = movedBy(targets, position.count)
  if (entries.length === 0 || !mesh.morphTargetInfluences) return null
  const values = new Float32Array(targets.length)
  const [weights, bounds, offsets] = [
    buffers.create('float', values),
    buffers.create('uint', starts),
    buffers.create('vec4', entries),
  ]
  const node = create()
  const pass = passOver(position.count, (i) => {
    const sum = vec3(at(from, i).xyz as Node<'vec3'>).toVar()
    const range = {
      start: at(bounds, i),
      end: at(bounds, i.add(1)),
      type: 'uint',
      condition: '<',
    } as const
    Loop(range, ({ i: k }) => {
      const entry = at(offsets, k).toVar()
      sum.addAssign(entry.xyz.mul(at(weights, uint(entry.w))))
    })
    at(node, i).assign(vec4(sum, 1))
  })
  const take = () => {
    const changed = takeNumbers(values, mesh.morphTargetInfluences!)
    if (changed) weights.value.needsUpdate = true
    return changed
  }
  return { node, pass, take }
}

/** For each vertex what moves it: x, y, z and number of the target; and where each vertex's list starts. */
function movedBy(targets: readonly Float32Array[], count: number) {
  const starts = new Uint32Array(count + 1)
  const entries: number[] = []
  for (let i = 0; i < count; i++) {
    for (let target = 0; target < targets.length; target++) {
      const [x, y, z] = [targets[target][3 * i], targets[target][3 * i + 1], targets[target][3 * i + 2]]
      if (x !== 0 || y !== 0 || z !== 0) entries.push(x, y, z, target)
    }
    starts[i + 1] = entries.length / 4
  }
  return { starts, entries: Float32Array.from(entries) }
}

/** Moves vertices as the skeleton says, in the mesh's own space as three.js does; null where there is none. */
function skinning(
  mesh: Mesh,
  from: StorageBufferNode<'vec4'>,
  buffers: Buffers,
  create: () => StorageBufferNode<'vec4'>,
): Step | null {
  const { skeleton } = mesh as Partial<SkinnedMesh>
  const { skinIndex, skinWeight } = mesh.geometry.attributes
  if (!skeleton || !skinIndex || !skinWeight) return null
  const values = new Float32Array(16 * skeleton.bones.length)
  const [matrices, joints, shares] = [
    buffers.create('mat4', values),
    buffers.create('uvec4', Uint32Array.from(coordinates(skinIndex, 4))),
    buffers.create('vec4', coordinates(skinWeight, 4)),
  ]
  const node = create()
  const pass = passOver(skinIndex.count, (i) => {
    const rest = vec4(at(from, i).xyz as Node<'vec3'>, 1).toVar()
    const joint = at(joints, i).toVar()
    const share = at(shares, i).toVar()
    const moved = (axis: 'x' | 'y' | 'z' | 'w') =>
      at(matrices, joint[axis]).mul(rest).xyz.mul(share[axis]) as Node<'vec3'>
    at(node, i).assign(vec4(moved('x').add(moved('y'), moved('z'), moved('w')), 1))
  })
  const now = values.slice()
  const take = () => {
    writeJoints(mesh as SkinnedMesh, now)
    const changed = takeNumbers(values, now)
    if (changed) matrices.value.needsUpdate = true
    return changed
  }
  return { node, pass, take }
}

const matrix = new Matrix4()

/** Of each joint, what takes a vertex from rest to where it is, in the mesh's own space. */
function writeJoints({ skeleton, bindMatrix, bindMatrixInverse }: SkinnedMesh, out: Float32Array): void {
  for (const [i, { matrixWorld }] of skeleton.bones.entries()) {
    matrix
      .multiplyMatrices(bindMatrixInverse, matrixWorld)
      .multiply(skeleton.boneInverses[i])
      .multiply(bindMatrix)
    matrix.toArray(out, 16 * i)
  }
}

/** Whether a simulation on the graphics card may move it. */
function isComputed(attribute: BufferAttribute | InterleavedBufferAttribute): attribute is BufferAttribute {
  return (attribute as { isStorageBufferAttribute?: boolean }).isStorageBufferAttribute === true
}

/** Three numbers each lie four apart there as well, so that both kinds are read as vec3. */
function sharedBuffer(attribute: BufferAttribute): StorageBufferNode<'vec4'> {
  return storage(attribute, 'vec3', attribute.count) as unknown as StorageBufferNode<'vec4'>
}

function versionOf(attribute: BufferAttribute | InterleavedBufferAttribute): number {
  return 'data' in attribute ? attribute.data.version : attribute.version
}

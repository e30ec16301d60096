import {
  type BufferAttribute,
  type BufferGeometry,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type SkinnedMesh,
} from 'three'
import { Loop, storage, uint, vec3, vec4 } from 'three/tsl'
import type { ComputeNode, StorageBufferNode } from 'three/webgpu'
import { coordinates, copyNumbers, targetOffsets } from '../../sources/geometry-arrays.ts'
import { Buffers, computePass, padToVec4, typedBuffer } from './buffers.ts'

/**
 * Vertex positions of a mesh after blendshapes and optional skinning, computed on the GPU. A buffer lists, for each vertex, only the
 * displacements by blendshapes that move the vertex. Memory and time are therefore proportional to the number of nonzero displacements.
 */
export class DeformedPositions {
  /** Positions of all vertices in the mesh's local space (xyz). */
  readonly node: StorageBufferNode<'vec4'>
  /** Passes that update `node`, in order. */
  readonly passes: readonly ComputeNode[]
  readonly #buffers = new Buffers()
  readonly #inputs: readonly { update(): boolean }[]

  constructor(mesh: Mesh, isSkinned: boolean) {
    const { position } = mesh.geometry.attributes
    const rest = isComputed(position)
      ? { node: computedPositions(position), update: () => true }
      : this.#uploadFrom(mesh.geometry)
    const create = () => this.#buffers.create('vec4', new Float32Array(4 * position.count))
    const morphed = morphing(mesh, rest.node, this.#buffers, create)
    const skinned = isSkinned ? skinning(mesh, morphed?.node ?? rest.node, this.#buffers, create) : null
    const steps = [morphed, skinned].filter((step) => step !== null)
    this.node = skinned?.node ?? morphed?.node ?? rest.node
    this.passes = steps.map(({ pass }) => pass)
    this.#inputs = [rest, ...steps]
  }

  /**
   * Reads the current positions, blendshape weights and joints.
   *
   * @returns whether the deformed positions may have changed.
   */
  update(): boolean {
    let changed = false
    for (const input of this.#inputs) if (input.update()) changed = true
    return changed
  }

  dispose(): void {
    for (const pass of this.passes) pass.dispose()
    this.#buffers.dispose()
  }

  /** Creates a buffer with a copy of the geometry's positions. Its `update` uploads them again after a change. */
  #uploadFrom(geometry: BufferGeometry) {
    const node = this.#buffers.create('vec4', padToVec4(coordinates(geometry.attributes.position)))
    let version = -1
    return {
      node,
      update() {
        const { position } = geometry.attributes
        if (versionOf(position) === version) return false
        if (version >= 0) padToVec4(coordinates(position), node.value.array as Float32Array<ArrayBuffer>)
        version = versionOf(position)
        node.value.needsUpdate = true
        return true
      },
    }
  }
}

/** A compute pass that reads the positions of a previous step, and writes deformed positions to `node`. */
interface Step {
  node: StorageBufferNode<'vec4'>
  pass: ComputeNode
  /** Reads the inputs of the pass. Returns whether they changed. */
  update(): boolean
}

/** Creates the step that adds the weighted morph targets; null if no target moves a vertex. */
function morphing(
  mesh: Mesh,
  from: StorageBufferNode<'vec4'>,
  buffers: Buffers,
  create: () => StorageBufferNode<'vec4'>,
): Step | null {
  const targets = targetOffsets(mesh.geometry)
  const { position } = mesh.geometry.attributes
  const { starts, entries } = offsetsByVertex(targets, position.count)
  if (entries.length === 0 || !mesh.morphTargetInfluences) return null
  const values = new Float32Array(targets.length)
  const [weights, bounds, offsets] = [
    buffers.create('float', values),
    buffers.create('uint', starts),
    buffers.create('vec4', entries),
  ]
  const node = create()
  const pass = computePass(position.count, (i) => {
    const sum = vec3(from.element(i).xyz).toVar()
    const range = {
      start: bounds.element(i),
      end: bounds.element(i.add(1)),
      type: 'uint',
      condition: '<',
    } as const
    Loop(range, ({ i: k }) => {
      const entry = offsets.element(k).toVar()
      sum.addAssign(entry.xyz.mul(weights.element(uint(entry.w))))
    })
    node.element(i).assign(vec4(sum, 1))
  })
  const update = () => {
    const changed = copyNumbers(values, mesh.morphTargetInfluences!)
    if (changed) weights.value.needsUpdate = true
    return changed
  }
  return { node, pass, update }
}

/**
 * Returns the nonzero displacements of all vertices as one array, vertex by vertex: xyz and target index. `starts` has the index of the first
 * displacement of each vertex.
 */
function offsetsByVertex(targets: readonly Float32Array[], count: number) {
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

/** Creates the step for linear blend skinning in the mesh's local space, as in three.js; null without a skeleton. */
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
  const [matrices, joints, weights] = [
    buffers.create('mat4', values),
    buffers.create('uvec4', Uint32Array.from(coordinates(skinIndex, 4))),
    buffers.create('vec4', coordinates(skinWeight, 4)),
  ]
  const node = create()
  const pass = computePass(skinIndex.count, (i) => {
    const rest = vec4(from.element(i).xyz, 1).toVar()
    const joint = joints.element(i).toVar()
    const weight = weights.element(i).toVar()
    const moved = (axis: 'x' | 'y' | 'z' | 'w') =>
      matrices.element(joint[axis]).mul(rest).xyz.mul(weight[axis])
    node.element(i).assign(vec4(moved('x').add(moved('y'), moved('z'), moved('w')), 1))
  })
  const current = values.slice()
  const update = () => {
    writeJointMatrices(mesh as SkinnedMesh, current)
    const changed = copyNumbers(values, current)
    if (changed) matrices.value.needsUpdate = true
    return changed
  }
  return { node, pass, update }
}

const matrix = new Matrix4()

/** Computes the matrices that move vertices from the bind pose to the current pose, in the mesh's local space, one per joint. */
function writeJointMatrices(
  { skeleton, bindMatrix, bindMatrixInverse }: SkinnedMesh,
  out: Float32Array,
): void {
  for (const [i, { matrixWorld }] of skeleton.bones.entries()) {
    matrix
      .multiplyMatrices(bindMatrixInverse, matrixWorld)
      .multiply(skeleton.boneInverses[i])
      .multiply(bindMatrix)
    matrix.toArray(out, 16 * i)
  }
}

/** Whether compute shaders may write to the attribute. */
function isComputed(attribute: BufferAttribute | InterleavedBufferAttribute): attribute is BufferAttribute {
  return (attribute as { isStorageBufferAttribute?: boolean }).isStorageBufferAttribute === true
}

/** Returns the positions of a storage attribute as a node. A `vec3` has the 16-byte alignment of a `vec4`, so it can be read as a `vec4`. */
function computedPositions(attribute: BufferAttribute): StorageBufferNode<'vec4'> {
  return typedBuffer(storage(attribute, 'vec3', attribute.count))
}

function versionOf(attribute: BufferAttribute | InterleavedBufferAttribute): number {
  return 'data' in attribute ? attribute.data.version : attribute.version
}

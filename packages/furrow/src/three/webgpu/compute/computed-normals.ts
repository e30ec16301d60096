import { BufferAttribute, BufferGeometry, type Mesh } from 'three'
import { cross, float, If, Loop, vec3, vec4 } from 'three/tsl'
import type { ComputeNode, Node, StorageBufferNode, WebGPURenderer } from 'three/webgpu'
import { HALF_TURN, NO_DIRECTION, sumNormals } from '../../../math/deformed-normals.ts'
import { weldVertices } from '../../../math/weld.ts'
import { coordinates, trianglesOf } from '../../sources/geometry-arrays.ts'
import { Buffers, computePass, padToVec4 } from './buffers.ts'
import { DeformedPositions } from './deformed-positions.ts'

/** A mesh at rest. Vertices at the same position are welded to one vertex. */
interface Rest {
  positions: Float32Array
  triangles: ArrayLike<number>
  /** For each vertex, the index of its welded vertex. */
  welded: Uint32Array
  weldedCount: number
}

/**
 * Recomputes the normals and tangents of a mesh in compute passes, by the algorithm of `DeformedNormals` in math/. The passes deform the
 * positions, compute the normal of each welded vertex, and apply its rotation from the rest pose to the normals and tangents of the file. The
 * last pass writes to the buffers that are drawn.
 */
export class ComputedNormals {
  readonly #mesh: Mesh
  readonly #original: BufferGeometry
  readonly #geometry: BufferGeometry
  readonly #buffers = new Buffers()
  readonly #positions: DeformedPositions
  readonly #passes: ComputeNode[]
  #renderer: WebGPURenderer | null = null

  constructor(mesh: Mesh) {
    this.#mesh = mesh
    this.#original = mesh.geometry
    this.#geometry = shareBuffers(mesh.geometry)
    this.#positions = new DeformedPositions(mesh, false)
    const rest = weld(this.#original)
    const sums = this.#buffers.create('vec4', new Float32Array(4 * rest.weldedCount))
    this.#passes = [
      ...this.#positions.passes,
      gatherNormals(this.#positions.node, rest, sums, this.#buffers),
      this.#rotateAuthored(rest, sums),
    ]
    setGeometry(mesh, this.#geometry)
  }

  update(renderer: WebGPURenderer): void {
    const isNewRenderer = renderer !== this.#renderer
    if (!this.#positions.update() && !isNewRenderer) return
    this.#renderer = renderer
    renderer.compute(this.#passes)
  }

  dispose(): void {
    setGeometry(this.#mesh, this.#original)
    detachBuffers(this.#geometry, this.#original)
    this.#geometry.dispose()
    for (const pass of this.#passes) pass.dispose()
    this.#positions.dispose()
    this.#buffers.dispose()
  }

  /** Creates the pass that rotates normals and tangents of the file. The rotation turns the welded normal at rest to the current one. */
  #rotateAuthored(rest: Rest, sums: StorageBufferNode<'vec4'>): ComputeNode {
    const { normal, tangent } = this.#original.attributes
    const welded = this.#buffers.create('uint', rest.welded)
    const directions = this.#buffers.create('vec4', directionsAtRest(rest))
    const authored = {
      normal: padToVec4(coordinates(normal)),
      tangent: tangent && coordinates(tangent, 4),
    }
    const rotated = (['normal', 'tangent'] as const)
      .filter((name) => authored[name])
      .map((name) => {
        const from = this.#buffers.create('vec4', authored[name])
        const to = this.#buffers.create('vec4', authored[name].slice())
        this.#geometry.setAttribute(name, to.value)
        return { from, to }
      })
    return computePass(rest.welded.length, (i) => {
      const vertex = welded.element(i).toVar()
      const before = directions.element(vertex).xyz.toVar()
      const sum = sums.element(vertex).xyz.toVar()
      const axis = vec3(0).toVar()
      const cosine = float(1).toVar()
      const squared = sum.dot(sum).toVar()
      If(squared.greaterThan(NO_DIRECTION), () => {
        const after = sum.div(squared.sqrt()).toVar()
        // If the welded normal at rest is undefined, i.e. (0, 0, 0), the values of the file are kept.
        const isRotated = before.dot(before).greaterThan(0).and(before.dot(after).greaterThan(HALF_TURN))
        If(isRotated, () => {
          cosine.assign(before.dot(after))
          axis.assign(cross(before, after))
        })
      })
      for (const { from, to } of rotated) {
        const source = from.element(i).toVar()
        to.element(i).assign(vec4(rotate(source.xyz, axis, cosine), source.w))
      }
    })
  }
}

/** Rotates a direction `d` about an axis `a` of length sin(angle) by Rodrigues' formula: `c * d + cross(a, d) + a * dot(a, d) / (1 + c)`. */
function rotate(direction: Node<'vec3'>, axis: Node<'vec3'>, cosine: Node<'float'>): Node<'vec3'> {
  const along = axis.dot(direction).div(cosine.add(1))
  return direction.mul(cosine).add(cross(axis, direction), axis.mul(along))
}

function weld(geometry: BufferGeometry): Rest {
  const positions = coordinates(geometry.attributes.position)
  const { pointOf: welded, count: weldedCount } = weldVertices(positions)
  return { positions, triangles: trianglesOf(geometry), welded, weldedCount }
}

/** Returns the unit normal at rest of each welded vertex, padded to four numbers; (0, 0, 0) if undefined. */
function directionsAtRest({ positions, triangles, welded, weldedCount }: Rest): Float32Array {
  const sums = new Float64Array(3 * weldedCount)
  sumNormals(sums, positions, triangles, welded)
  for (let i = 0; i < sums.length; i += 3) {
    const squared = sums[i] ** 2 + sums[i + 1] ** 2 + sums[i + 2] ** 2
    const scale = squared > NO_DIRECTION ? 1 / Math.sqrt(squared) : 0
    for (let axis = 0; axis < 3; axis++) sums[i + axis] *= scale
  }
  return padToVec4(sums)
}

/**
 * Creates the pass that sums the area-weighted normals of the triangles around each welded vertex. Each invocation loops over the triangles of
 * one vertex, because WGSL has no atomic addition of floats.
 */
function gatherNormals(
  positions: StorageBufferNode<'vec4'>,
  { triangles, welded, weldedCount }: Rest,
  sums: StorageBufferNode<'vec4'>,
  buffers: Buffers,
): ComputeNode {
  const { starts, list: around } = trianglesAround(welded, weldedCount, triangles)
  const [bounds, list, corners] = [
    buffers.create('uint', starts),
    buffers.create('uint', around),
    buffers.create('uint', Uint32Array.from(triangles)),
  ]
  return computePass(weldedCount, (i) => {
    const sum = vec3(0).toVar()
    const range = {
      start: bounds.element(i),
      end: bounds.element(i.add(1)),
      type: 'uint',
      condition: '<',
    } as const
    Loop(range, ({ i: k }) => {
      const first = list.element(k).mul(3).toVar()
      const [a, b, c] = [0, 1, 2].map((corner) => positions.element(corners.element(first.add(corner))).xyz)
      sum.addAssign(cross(b.sub(a), c.sub(a)))
    })
    sums.element(i).assign(vec4(sum, 0))
  })
}

/** Returns the triangles around each welded vertex as one array, vertex by vertex, with the start of each vertex's triangles. */
function trianglesAround(welded: Uint32Array, weldedCount: number, triangles: ArrayLike<number>) {
  const lists = Array.from({ length: weldedCount }, (): number[] => [])
  const complete = triangles.length - (triangles.length % 3)
  for (let k = 0; k < complete; k++) lists[welded[triangles[k]]].push(Math.floor(k / 3))
  const starts = new Uint32Array(weldedCount + 1)
  for (let i = 0; i < weldedCount; i++) starts[i + 1] = starts[i] + lists[i].length
  return { starts, list: Uint32Array.from(lists.flat()) }
}

/** Replaces the geometry of a mesh. Also rebuilds its materials, because three.js r186 keeps pipelines with the old attribute strides. */
function setGeometry(mesh: Mesh, geometry: BufferGeometry): void {
  mesh.geometry = geometry
  for (const material of [mesh.material].flat()) material.needsUpdate = true
}

/** Creates a geometry that shares the buffers of another geometry, except its morph normals. */
function shareBuffers(geometry: BufferGeometry): BufferGeometry {
  const { attributes, morphAttributes, morphTargetsRelative, index, groups, drawRange } = geometry
  const { name, userData, boundingBox, boundingSphere } = geometry
  const { normal, ...others } = morphAttributes
  const rest = { morphTargetsRelative, index, groups, drawRange, name, userData, boundingBox, boundingSphere }
  return Object.assign(new BufferGeometry(), {
    attributes: { ...attributes },
    morphAttributes: others,
    ...rest,
  })
}

/** Replaces the shared buffers of a geometry by empty buffers, so that disposing of the geometry does not free the shared buffers. */
function detachBuffers(geometry: BufferGeometry, { attributes }: BufferGeometry): void {
  geometry.setIndex(null)
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    if (attribute === attributes[name])
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(), attribute.itemSize))
  }
}

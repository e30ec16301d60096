import { BufferAttribute, BufferGeometry, type Mesh } from 'three'
import { cross, float, If, Loop, vec3, vec4 } from 'three/tsl'
import type { ComputeNode, Node, StorageBufferNode, WebGPURenderer } from 'three/webgpu'
import { HALF_TURN, NO_DIRECTION, sumNormals } from '../../math/deformed-normals.ts'
import { weldVertices } from '../../math/weld.ts'
import { coordinates, trianglesOf } from '../sources/geometry-arrays.ts'
import { at, Buffers, padded, passOver } from './buffers.ts'
import { DeformedPositions } from './deformed-positions.ts'

/** The mesh at rest, as numbers. */
interface Rest {
  positions: Float32Array
  triangles: ArrayLike<number>
  places: Uint32Array
  placeCount: number
}

/**
 * `DeformedNormals` of math/ on the GPU. Positions are deformed; each place gathers the normals of the triangles round it, since
 * there is no atomic sum of floats; each vertex turns its authored normal and tangent as its place's direction has
 * turned, in the very buffers that it is drawn from.
 */
export class ComputedNormals {
  readonly #mesh: Mesh
  readonly #before: BufferGeometry
  readonly #geometry: BufferGeometry
  readonly #buffers = new Buffers()
  readonly #positions: DeformedPositions
  readonly #passes: ComputeNode[]
  #renderer: WebGPURenderer | null = null

  constructor(mesh: Mesh) {
    this.#mesh = mesh
    this.#before = mesh.geometry
    this.#geometry = shareGeometry(mesh.geometry)
    this.#positions = new DeformedPositions(mesh, false)
    const rest = measure(this.#before)
    const now = this.#buffers.create('vec4', new Float32Array(4 * rest.placeCount))
    this.#passes = [
      ...this.#positions.passes,
      gatherNormals(this.#positions.node, rest, now, this.#buffers),
      this.#turn(rest, now),
    ]
    mesh.geometry = this.#geometry
  }

  update(renderer: WebGPURenderer): void {
    const isOther = renderer !== this.#renderer
    if (!this.#positions.take() && !isOther) return
    this.#renderer = renderer
    renderer.compute(this.#passes)
  }

  dispose(): void {
    this.#mesh.geometry = this.#before
    unshare(this.#geometry, this.#before)
    this.#geometry.dispose()
    for (const pass of this.#passes) pass.dispose()
    this.#positions.dispose()
    this.#buffers.dispose()
  }

  /** Turns what was authored at each vertex from its place's direction at rest to that of now. */
  #turn(rest: Rest, now: StorageBufferNode<'vec4'>): ComputeNode {
    const { normal, tangent } = this.#before.attributes
    const places = this.#buffers.create('uint', rest.places)
    const directions = this.#buffers.create('vec4', directionsAtRest(rest))
    const authored = { normal: padded(coordinates(normal)), tangent: tangent && coordinates(tangent, 4) }
    const turned = (['normal', 'tangent'] as const)
      .filter((name) => authored[name])
      .map((name) => {
        const from = this.#buffers.create('vec4', authored[name])
        const to = this.#buffers.create('vec4', authored[name].slice())
        this.#geometry.setAttribute(name, to.value)
        return { from, to }
      })
    return passOver(rest.places.length, (i) => {
      const place = at(places, i).toVar()
      const before = at(directions, place).xyz.toVar() as Node<'vec3'>
      const sum = at(now, place).xyz.toVar() as Node<'vec3'>
      const axis = vec3(0).toVar()
      const cosine = float(1).toVar()
      const squared = sum.dot(sum).toVar()
      If(squared.greaterThan(NO_DIRECTION), () => {
        const after = sum.div(squared.sqrt()).toVar() as Node<'vec3'>
        // A place without a direction at rest has (0, 0, 0) there; whatever it comes to it is left as it was.
        const isTurned = before.dot(before).greaterThan(0).and(before.dot(after).greaterThan(HALF_TURN))
        If(isTurned, () => {
          cosine.assign(before.dot(after))
          axis.assign(cross(before, after))
        })
      })
      for (const { from, to } of turned) {
        const own = at(from, i).toVar()
        at(to, i).assign(vec4(rotate(own.xyz as Node<'vec3'>, axis, cosine), own.w))
      }
    })
  }
}

/** The shortest turn, by Rodrigues' formula as in math/deformed-normals: d c + (a x d) + a (a . d) / (1 + c). */
function rotate(direction: Node<'vec3'>, axis: Node<'vec3'>, cosine: Node<'float'>): Node<'vec3'> {
  const along = axis.dot(direction).div(cosine.add(1))
  return direction.mul(cosine).add(cross(axis, direction), axis.mul(along)) as Node<'vec3'>
}

function measure(geometry: BufferGeometry): Rest {
  const positions = coordinates(geometry.attributes.position)
  const { pointOf: places, count } = weldVertices(positions)
  return { positions, triangles: trianglesOf(geometry), places, placeCount: count }
}

/** Of each place, of length 1, four numbers apart; (0, 0, 0) where it has none. */
function directionsAtRest({ positions, triangles, places, placeCount }: Rest): Float32Array {
  const sums = new Float64Array(3 * placeCount)
  sumNormals(sums, positions, triangles, places)
  for (let i = 0; i < sums.length; i += 3) {
    const squared = sums[i] ** 2 + sums[i + 1] ** 2 + sums[i + 2] ** 2
    const scale = squared > NO_DIRECTION ? 1 / Math.sqrt(squared) : 0
    for (let axis = 0; axis < 3; axis++) sums[i + axis] *= scale
  }
  return padded(sums)
}

/** Sums, for each place, the normals of the triangles round it, by their areas. */
function gatherNormals(
  positions: StorageBufferNode<'vec4'>,
  { triangles, places, placeCount }: Rest,
  sums: StorageBufferNode<'vec4'>,
  buffers: Buffers,
): ComputeNode {
  const { starts, list: around } = trianglesRound(places, placeCount, triangles)
  const [bounds, list, corners] = [
    buffers.create('uint', starts),
    buffers.create('uint', around),
    buffers.create('uint', Uint32Array.from(triangles)),
  ]
  return passOver(placeCount, (i) => {
    const sum = vec3(0).toVar()
    const range = { start: at(bounds, i), end: at(bounds, i.add(1)), type: 'uint', condition: '<' } as const
    Loop(range, ({ i: k }) => {
      const first = at(list, k).mul(3).toVar()
      const [a, b, c] = [0, 1, 2].map(
        (corner) => at(positions, at(corners, first.add(corner))).xyz as Node<'vec3'>,
      )
      sum.addAssign(cross(b.sub(a), c.sub(a)))
    })
    at(sums, i).assign(vec4(sum, 0))
  })
}

/** Numbers of the triangles round each place, one place after the other, and where each begins, and the last ends. */
function trianglesRound(places: Uint32Array, placeCount: number, triangles: ArrayLike<number>) {
  const lists = Array.from({ length: placeCount }, (): number[] => [])
  const complete = triangles.length - (triangles.length % 3)
  for (let k = 0; k < complete; k++) lists[places[triangles[k]]].push(Math.floor(k / 3))
  const starts = new Uint32Array(placeCount + 1)
  for (let i = 0; i < placeCount; i++) starts[i + 1] = starts[i] + lists[i].length
  return { starts, list: Uint32Array.from(lists.flat()) }
}

/** A geometry that draws from another's buffers, so that whatever moves its positions moves both; without normals of targets. */
function shareGeometry(geometry: BufferGeometry): BufferGeometry {
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

/** Puts empty buffers in the place of another's, since renderers free all that a geometry has when it is disposed of. */
function unshare(geometry: BufferGeometry, { attributes }: BufferGeometry): void {
  geometry.setIndex(null)
  for (const [name, own] of Object.entries(geometry.attributes)) {
    if (own === attributes[name])
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(), own.itemSize))
  }
}

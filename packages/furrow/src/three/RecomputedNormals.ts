import { BufferAttribute, type BufferGeometry, DynamicDrawUsage, type Mesh } from 'three'
import { DeformedNormals } from '../math/deformed-normals.ts'
import { checkNormals } from './mesh/check-mesh.ts'
import { coordinates, copyNumbers, targetOffsets, trianglesOf } from './sources/geometry-arrays.ts'

/** The vertices that a blendshape moves. */
interface Offsets {
  vertices: Uint32Array
  /** x, y and z by which each moves. */
  values: Float32Array
}

/**
 * Recomputes a mesh's normals and tangents on the CPU as its blendshapes deform it, as the paper does, so that light and wrinkles
 * follow: three.js shades a face whose targets lack normals as if at rest, and never deforms tangents. Skinning is applied afterwards, as
 * before. The mesh gets a geometry of its own. Call `update` once per frame; while no weight changes it does nothing, and it never
 * allocates. Its cost is proportional to the vertices that move. `furrow pack --morph-normals` makes the file larger instead, and leaves
 * the tangents at rest.
 */
export class RecomputedNormals {
  readonly #mesh: Mesh
  readonly #before: BufferGeometry
  readonly #geometry: BufferGeometry
  readonly #deformed: DeformedNormals
  readonly #rest: Float32Array
  readonly #now: Float32Array
  readonly #normal: BufferAttribute
  readonly #tangent: BufferAttribute | null
  readonly #restTangents: Float32Array | null
  readonly #targets: readonly Offsets[]
  /** Weights that the normals were last computed for. */
  readonly #weights: Float32Array

  /**
   * @param mesh with normals; without blendshapes `update` does nothing.
   * @throws FurrowError when it is not a mesh, or has no normals.
   */
  constructor(mesh: Mesh) {
    checkNormals(mesh, 'RecomputedNormals')
    this.#mesh = mesh
    this.#before = mesh.geometry
    this.#geometry = mesh.geometry.clone()
    const { attributes, morphAttributes } = this.#geometry
    this.#rest = coordinates(attributes.position)
    this.#now = this.#rest.slice()
    const normals = coordinates(attributes.normal)
    const triangles = trianglesOf(this.#geometry)
    this.#deformed = new DeformedNormals({ positions: this.#rest, normals, triangles })
    this.#normal = new BufferAttribute(normals, 3).setUsage(DynamicDrawUsage)
    this.#restTangents = attributes.tangent ? coordinates(attributes.tangent, 4) : null
    this.#tangent =
      this.#restTangents && new BufferAttribute(this.#restTangents.slice(), 4).setUsage(DynamicDrawUsage)
    this.#geometry.setAttribute('normal', this.#normal)
    if (this.#tangent) this.#geometry.setAttribute('tangent', this.#tangent)
    delete morphAttributes.normal
    this.#targets = targetOffsets(this.#geometry).map(movedOnly)
    this.#weights = new Float32Array(this.#targets.length)
    mesh.geometry = this.#geometry
  }

  /** Brings normals and tangents up to date with the mesh's blendshapes. */
  update(): void {
    const influences = this.#mesh.morphTargetInfluences
    if (!influences || !copyNumbers(this.#weights, influences)) return
    this.#now.set(this.#rest)
    for (let i = 0; i < this.#targets.length; i++) this.#add(this.#targets[i], i)
    this.#deformed.update(this.#now, this.#normal.array as Float32Array)
    this.#normal.needsUpdate = true
    if (!this.#tangent || !this.#restTangents) return
    const tangents = this.#tangent.array as Float32Array
    tangents.set(this.#restTangents)
    this.#deformed.rotate(tangents, 4)
    this.#tangent.needsUpdate = true
  }

  /** Restores the mesh's geometry. */
  dispose(): void {
    this.#mesh.geometry = this.#before
    this.#geometry.dispose()
  }

  #add({ vertices, values }: Offsets, target: number): void {
    const weight = this.#weights[target]
    if (weight === 0) return
    for (let i = 0; i < vertices.length; i++) {
      const x = 3 * vertices[i]
      this.#now[x] += weight * values[3 * i]
      this.#now[x + 1] += weight * values[3 * i + 1]
      this.#now[x + 2] += weight * values[3 * i + 2]
    }
  }
}

/** Leaves out vertices that do not move. */
function movedOnly(offsets: Float32Array): Offsets {
  const vertices = Array.from({ length: offsets.length / 3 }, (_, i) => i).filter(
    (i) => offsets[3 * i] !== 0 || offsets[3 * i + 1] !== 0 || offsets[3 * i + 2] !== 0,
  )
  return {
    vertices: Uint32Array.from(vertices),
    values: Float32Array.from(
      vertices.flatMap((i) => [offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2]]),
    ),
  }
}

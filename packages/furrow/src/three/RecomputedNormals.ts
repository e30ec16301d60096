import { BufferAttribute, type BufferGeometry, DynamicDrawUsage, type Mesh } from 'three'
import { DeformedNormals } from '../math/deformed-normals.ts'
import { checkNormals } from './mesh/check-mesh.ts'
import { coordinates, copyNumbers, targetOffsets, trianglesOf } from './sources/geometry-arrays.ts'

/** Displacement by a blendshape. */
interface Offsets {
  /** Indices of the vertices that the blendshape moves. */
  vertices: Uint32Array
  /** Packed xyz displacement of each of these vertices. */
  values: Float32Array
}

/**
 * Recomputes a mesh's normals and tangents on the CPU as its blendshapes deform the mesh. three.js never deforms tangents. If blendshapes
 * have no normals, it shades the deformed mesh with the normals of the rest pose. three.js applies skinning to the recomputed normals.
 *
 * The mesh gets its own copy of the geometry. Call `update` once per frame. `update` does nothing while no weight changes, and never
 * allocates. Alternatively, `furrow pack --morph-normals` stores normals in the file. The file is then larger, and tangents are not deformed.
 */
export class RecomputedNormals {
  readonly #mesh: Mesh
  readonly #original: BufferGeometry
  readonly #geometry: BufferGeometry
  readonly #deformed: DeformedNormals
  readonly #rest: Float32Array
  readonly #positions: Float32Array
  readonly #normal: BufferAttribute
  readonly #tangent: BufferAttribute | null
  readonly #restTangents: Float32Array | null
  readonly #targets: readonly Offsets[]
  /** Blendshape weights at the last update. */
  readonly #weights: Float32Array

  /**
   * @param mesh mesh with normals. Without blendshapes `update` does nothing.
   * @throws FurrowError if `mesh` is not a mesh, or has no normals.
   */
  constructor(mesh: Mesh) {
    checkNormals(mesh, 'RecomputedNormals')
    this.#mesh = mesh
    this.#original = mesh.geometry
    this.#geometry = mesh.geometry.clone()
    const { attributes, morphAttributes } = this.#geometry
    this.#rest = coordinates(attributes.position)
    this.#positions = this.#rest.slice()
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

  /** Updates normals and tangents from the current blendshape weights. */
  update(): void {
    const influences = this.#mesh.morphTargetInfluences
    if (!influences || !copyNumbers(this.#weights, influences)) return
    this.#positions.set(this.#rest)
    for (let i = 0; i < this.#targets.length; i++) this.#add(this.#targets[i], i)
    this.#deformed.update(this.#positions, this.#normal.array as Float32Array)
    this.#normal.needsUpdate = true
    if (!this.#tangent || !this.#restTangents) return
    const tangents = this.#tangent.array as Float32Array
    tangents.set(this.#restTangents)
    this.#deformed.rotate(tangents, 4)
    this.#tangent.needsUpdate = true
  }

  /** Restores the mesh's original geometry. */
  dispose(): void {
    this.#mesh.geometry = this.#original
    this.#geometry.dispose()
  }

  #add({ vertices, values }: Offsets, target: number): void {
    const weight = this.#weights[target]
    if (weight === 0) return
    for (let i = 0; i < vertices.length; i++) {
      const x = 3 * vertices[i]
      this.#positions[x] += weight * values[3 * i]
      this.#positions[x + 1] += weight * values[3 * i + 1]
      this.#positions[x + 2] += weight * values[3 * i + 2]
    }
  }
}

/** Drops vertices with zero displacement. */
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

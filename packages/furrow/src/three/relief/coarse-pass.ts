import {
  type BufferGeometry,
  FloatType,
  type Material,
  type Mesh,
  NearestFilter,
  OrthographicCamera,
  Points,
  RenderTarget,
  Scene,
  type SkinnedMesh,
  type Texture,
} from 'three'
import { renderPreservingState } from '../atlas/render-preserving-state.ts'
import type { AnyRenderer } from '../renderer.ts'
import { copyNumbers } from '../sources/geometry-arrays.ts'

/** Texels in a row of the coarse textures. */
export const COARSE_WIDTH = 512

/** What depends on the renderer: how vertices are written, and whether a target still holds them. */
export interface CoarseParts {
  /**
   * A material for points that writes two textures, a texel for each vertex of a geometry, deformed in the mesh's local space: its
   * position, and in w the next vertex at the same position; its normal and its tangent, each as a point of an octahedron (Z. Cigolle et
   * al., "A Survey of Efficient Representations for Independent Unit Vectors", 2014), since three textures of floats are more than every
   * WebGPU device can write at once.
   *
   * @param first texel of the geometry's first vertex.
   * @param rows of the textures.
   */
  coarseMaterial(ring: Texture, first: number, rows: number, hasTangents: boolean): Material
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}

/** Vertices of the meshes of one face as three.js deforms them, by blendshapes and skeleton, in textures. */
export class CoarsePass {
  readonly target: RenderTarget
  readonly #parts: CoarseParts
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #poses: Pose[]
  /** The renderer whose target holds the vertices: a page may make another one, as after the loss of a device. */
  #renderer: AnyRenderer | null = null

  /**
   * @param meshes with the texel of each one's first vertex.
   * @param ring the next vertex at the same position, of each texel.
   */
  constructor(meshes: readonly { mesh: Mesh; first: number }[], ring: Texture, parts: CoarseParts) {
    const { height: rows } = ring.image as { height: number }
    this.#parts = parts
    this.target = new RenderTarget(COARSE_WIDTH, rows, {
      count: 2,
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthBuffer: false,
    })
    this.#scene.matrixWorldAutoUpdate = false
    for (const { mesh, first } of meshes) {
      const material = parts.coarseMaterial(ring, first, rows, 'tangent' in mesh.geometry.attributes)
      this.#scene.add(pointsOf(mesh, material))
    }
    this.#poses = meshes.map(({ mesh }) => new Pose(mesh))
  }

  /** Draws the vertices, if any may have moved. */
  update(renderer: AnyRenderer): void {
    let changed = renderer !== this.#renderer || !this.#parts.hasContents(renderer, this.target)
    this.#renderer = renderer
    for (const pose of this.#poses) if (pose.update()) changed = true
    if (changed) this.#draw(renderer)
  }

  dispose(): void {
    for (const { material } of this.#scene.children as Points[]) (material as Material).dispose()
    this.target.dispose()
  }

  #draw(renderer: AnyRenderer): void {
    const points = this.#scene.children as Points[]
    const restore = points.map((object, i) => {
      // RecomputedNormals exchanges the geometry.
      object.geometry = this.#poses[i].mesh.geometry
      return drawEachVertex(object.geometry)
    })
    renderPreservingState(renderer, this.target, this.#scene, this.#camera)
    for (const undo of restore) undo()
  }
}

/** Without an index, each vertex is drawn once. The geometry itself is used, since three.js keeps the textures of its blendshapes with it. */
function drawEachVertex(geometry: BufferGeometry): () => void {
  const { index, drawRange } = geometry
  const { start, count } = drawRange
  geometry.index = null
  geometry.setDrawRange(0, Infinity)
  return () => {
    geometry.index = index
    geometry.setDrawRange(start, count)
  }
}

/** Points that three.js deforms as a mesh. */
function pointsOf(mesh: Mesh, material: Material): Points {
  const points = new Points(mesh.geometry, material)
  points.frustumCulled = false
  points.morphTargetInfluences = mesh.morphTargetInfluences
  points.morphTargetDictionary = mesh.morphTargetDictionary
  const { isSkinnedMesh, skeleton, bindMatrix, bindMatrixInverse } = mesh as SkinnedMesh
  return isSkinnedMesh
    ? Object.assign(points, { isSkinnedMesh, skeleton, bindMatrix, bindMatrixInverse })
    : points
}

/** What the shape of a mesh depends on. */
class Pose {
  readonly mesh: Mesh
  readonly #weights: Float32Array
  readonly #bones: Float32Array
  readonly #current: Float32Array
  #version = -1

  constructor(mesh: Mesh) {
    this.mesh = mesh
    const bones = (mesh as Partial<SkinnedMesh>).skeleton?.bones.length ?? 0
    this.#weights = new Float32Array(mesh.morphTargetInfluences?.length ?? 0)
    this.#bones = new Float32Array(bones > 0 ? 16 * (bones + 1) : 0)
    this.#current = this.#bones.slice()
  }

  /** Reads it; returns whether anything has changed. */
  update(): boolean {
    const { mesh } = this
    const { skeleton, bindMatrixInverse } = mesh as Partial<SkinnedMesh>
    const { position, normal } = mesh.geometry.attributes
    const version = versionOf(position) + versionOf(normal)
    let changed = version !== this.#version || isComputed(position) || isComputed(normal)
    this.#version = version
    if (copyNumbers(this.#weights, mesh.morphTargetInfluences ?? [])) changed = true
    if (!skeleton) return changed
    for (let i = 0; i < skeleton.bones.length; i++)
      skeleton.bones[i].matrixWorld.toArray(this.#current, 16 * i)
    bindMatrixInverse!.toArray(this.#current, 16 * skeleton.bones.length)
    return copyNumbers(this.#bones, this.#current) || changed
  }
}

type Attribute = BufferGeometry['attributes'][string]

function versionOf(attribute: Attribute): number {
  return 'data' in attribute ? attribute.data.version : (attribute as { version: number }).version
}

/** Whether the graphics card itself may write to it. */
function isComputed(attribute: Attribute): boolean {
  return (attribute as { isStorageBufferAttribute?: boolean }).isStorageBufferAttribute === true
}

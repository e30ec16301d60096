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

/** Width of the coarse textures, texels. */
export const COARSE_WIDTH = 512

/** Renderer-specific parts of the coarse pass. */
export interface CoarseParts {
  /**
   * Creates a points material that writes each deformed vertex, in the mesh's local space, to one texel of two textures. Texture 0: xyz =
   * position, w = next vertex at the same position. Texture 1: normal and tangent, octahedral-encoded (Z. Cigolle et al., "A Survey of
   * Efficient Representations for Independent Unit Vectors", 2014), because some WebGPU devices cannot write three float textures at once.
   *
   * @param first texel of the geometry's first vertex.
   * @param rows height of the textures, texels.
   */
  coarseMaterial(ring: Texture, first: number, rows: number, hasTangents: boolean): Material
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}

/** Renders the vertices of a face, deformed by three.js's blendshapes and skinning, into textures. */
export class CoarsePass {
  readonly target: RenderTarget
  readonly #parts: CoarseParts
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #poses: Pose[]
  /** Renderer that has drawn the vertices into its textures. The page may create another renderer, e.g. after a device loss. */
  #renderer: AnyRenderer | null = null

  /**
   * @param meshes meshes, each with the texel of its first vertex.
   * @param ring next vertex at the same position, per texel.
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

  /** Redraws the vertices if any may have moved. */
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
      // RecomputedNormals replaces the geometry.
      object.geometry = this.#poses[i].mesh.geometry
      return drawEachVertex(object.geometry)
    })
    renderPreservingState(renderer, this.target, this.#scene, this.#camera)
    for (const undo of restore) undo()
  }
}

/**
 * Removes the index, so that each vertex is drawn once. Edits the geometry in place, because three.js caches its morph texture by geometry.
 *
 * @returns a function that restores the geometry.
 */
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

/** Creates points that three.js deforms like the mesh. */
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

/** Detects pose changes of a mesh. */
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

  /** Reads the current pose. Returns whether it has changed. */
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

/** Whether compute shaders may write to the attribute. */
function isComputed(attribute: Attribute): boolean {
  return (attribute as { isStorageBufferAttribute?: boolean }).isStorageBufferAttribute === true
}

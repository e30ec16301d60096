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

/** Width in texels of the textures that `CoarsePass` draws. */
export const COARSE_WIDTH = 512

/** Renderer-specific functions of `CoarsePass`. */
export interface CoarseParts {
  /**
   * Creates a material for `Points` that writes each deformed vertex, in the mesh's local space, to the same texel of two textures. Texture 0
   * holds the position (xyz), and the texel of the next vertex at the same position (w, see `ring`). Texture 1 holds the normal (xy) and the
   * tangent (zw) in octahedral encoding (Z. Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors", 2014).
   * Without the encoding, a third texture would be needed, and some WebGPU devices cannot draw to three float textures at once.
   *
   * @param ring texture that maps the texel of each vertex to the texel of the next vertex at the same position.
   * @param first texel of the geometry's first vertex.
   * @param rows height of the textures, texels.
   */
  coarseMaterial(ring: Texture, first: number, rows: number, hasTangents: boolean): Material
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}

/**
 * Renders the vertices of a face's meshes into textures, after three.js has deformed them by blendshapes and skinning. Shaders of relief read
 * the textures to place the vertices of finer geometries, which have no blendshapes or skinning.
 */
export class CoarsePass {
  readonly target: RenderTarget
  readonly #parts: CoarseParts
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #poses: Pose[]
  /** Renderer that has drawn the textures. The page may create another renderer, e.g. after it has lost the GPU device. */
  #renderer: AnyRenderer | null = null

  /**
   * @param meshes meshes, each with the texel of its first vertex.
   * @param ring see `CoarseParts.coarseMaterial`.
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

  /** Redraws the textures if any vertex may have moved. */
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
      // `RecomputedNormals` may have replaced the geometry of the mesh.
      object.geometry = this.#poses[i].mesh.geometry
      return drawEachVertex(object.geometry)
    })
    renderPreservingState(renderer, this.target, this.#scene, this.#camera)
    for (const undo of restore) undo()
  }
}

/**
 * Removes the index of a geometry, so that each vertex is drawn once. Changes the geometry itself, because three.js would create a second
 * morph texture for a copy.
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

/** Creates `Points` with the blendshapes and skeleton of a mesh. */
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

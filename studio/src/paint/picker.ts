import type { SkinSurface } from 'furrow/internal'
import {
  BackSide,
  Box3,
  DoubleSide,
  FrontSide,
  type Material,
  Ray,
  type Side,
  Triangle,
  Vector3,
} from 'three'
import type { MeshBVH } from 'three-mesh-bvh'
import { restoreHierarchy } from './hierarchy.ts'
import type { SkinData } from './make-skin.ts'
import type { PaintSkin, SkinPoint } from './paint-skin.ts'
import type { MeshSkin } from './read-skin.ts'
import type { Sight } from './visible-places.ts'

/** Depth tolerance of visibility tests, as a fraction of the diagonal of the skin's bounding box. */
const DEPTH_TOLERANCE = 1e-3

/** Point of the skin under the pointer. */
export interface SkinHit extends SkinPoint {
  /** Barycentric coordinates in the triangle. */
  weights: [a: number, b: number, c: number]
  /** Texture coordinates, v = 0 at the top. */
  uv: [u: number, v: number]
  /** Position and unit normal on the deformed skin, world space. The normal points towards the camera. */
  point: Vector3
  normal: Vector3
}

/** Finds points of the deformed skin under the pointer. */
export class SkinPicker {
  readonly #parts: MeshSkin['parts']
  readonly #surface: SkinSurface
  readonly #indices: ArrayLike<number>
  readonly #uvs: ArrayLike<number>
  /** Deformed positions in world space. */
  readonly #positions: Float32Array
  readonly #hierarchy: MeshBVH
  /** For each triangle of the skin: its index in the surface, or -1 if the triangle is degenerate. */
  readonly #triangleOf: Int32Array
  #poses = 0

  /**
   * @param painted paintable skin of the same meshes.
   * @param made result of `makeSkin`.
   */
  constructor({ skin, parts }: MeshSkin, painted: PaintSkin, made: Pick<SkinData, 'indices' | 'hierarchy'>) {
    this.#parts = parts
    this.#surface = painted.surface
    this.#indices = skin.indices
    this.#uvs = painted.skin.uvs
    this.#positions = new Float32Array(skin.positions.length)
    this.#triangleOf = new Int32Array(Math.floor(skin.indices.length / 3)).fill(-1)
    for (const [t, skinTriangle] of this.#surface.skinTriangles.entries()) this.#triangleOf[skinTriangle] = t
    this.#deform()
    this.#hierarchy = restoreHierarchy(made.hierarchy, this.#positions, made.indices)
  }

  /** Number of calls of `refit`. If it has changed, the pose may have changed. */
  get poses(): number {
    return this.#poses
  }

  refit(): void {
    this.#poses++
    this.#deform()
    this.#hierarchy.refit()
  }

  /** Returns the first point of the skin that a ray in world space hits, or undefined. */
  pick(ray: Ray): SkinHit | undefined {
    const found = this.#hierarchy.raycastFirst(ray, this.#side)
    if (!found || found.faceIndex == null || !found.barycoord) return undefined
    const triangle = this.#triangleOf[found.faceIndex]
    const { x, y, z } = found.barycoord
    const weights: SkinHit['weights'] = [x, y, z]
    const { points, corners } = this.#surface
    const position = mix(points, 3, corners, triangle, weights)
    const uv = mix(this.#uvs, 2, this.#indices, found.faceIndex, weights)
    const normal = found.face!.normal.clone()
    if (normal.dot(ray.direction) > 0) normal.negate()
    return {
      triangle,
      weights,
      position: [position[0], position[1], position[2]],
      uv: [uv[0], uv[1]],
      point: found.point.clone(),
      normal,
    }
  }

  /** Computes the deformed position of a skin point in world space. */
  positionOf(triangle: number, weights: ArrayLike<number>, out: Vector3): Vector3 {
    const first = 3 * this.#surface.skinTriangles[triangle]
    out.set(0, 0, 0)
    for (let k = 0; k < 3; k++) {
      const [at, weight] = [3 * this.#indices[first + k], weights[k]]
      out.x += weight * this.#positions[at]
      out.y += weight * this.#positions[at + 1]
      out.z += weight * this.#positions[at + 2]
    }
    return out
  }

  /** Returns a visibility test for a camera position in world space. Tests occlusion by the skin only. Valid until the pose changes. */
  sightFrom(eye: Vector3): Sight {
    const side = this.#side
    const ray = new Ray(eye.clone())
    const [a, b, c, point, normal] = Array.from({ length: 5 }, () => new Vector3())
    const size = this.#hierarchy.getBoundingBox(new Box3()).getSize(new Vector3()).length()
    return (triangle, [wa, wb, wc]) => {
      const first = 3 * this.#surface.skinTriangles[triangle]
      for (const [k, corner] of [a, b, c].entries())
        corner.fromArray(this.#positions, 3 * this.#indices[first + k])
      point.set(0, 0, 0).addScaledVector(a, wa).addScaledVector(b, wb).addScaledVector(c, wc)
      ray.direction.subVectors(point, eye)
      const facing = -Triangle.getNormal(a, b, c, normal).dot(ray.direction)
      if ((side === FrontSide && facing <= 0) || (side === BackSide && facing >= 0)) return false
      const distance = ray.direction.length()
      ray.direction.divideScalar(distance)
      return this.#hierarchy.raycastFirst(ray, side, 0, distance - DEPTH_TOLERANCE * size) === null
    }
  }

  /** Triangle side that the material renders. Front and back are swapped for mirrored meshes. */
  get #side(): Side {
    const [{ mesh }] = this.#parts
    const { side } = [mesh.material].flat()[0] as Material
    if (side === DoubleSide) return side
    const isMirrored = mesh.matrixWorld.determinant() < 0
    return (side === FrontSide) === isMirrored ? BackSide : FrontSide
  }

  #deform(): void {
    const point = new Vector3()
    let i = 0
    for (const { mesh, vertices } of this.#parts) {
      let root = mesh.parent ?? mesh
      while (root.parent) root = root.parent
      root.updateMatrixWorld()
      for (const vertex of vertices) {
        mesh.getVertexPosition(vertex, point).applyMatrix4(mesh.matrixWorld).toArray(this.#positions, i)
        i += 3
      }
    }
  }
}

function mix(
  values: ArrayLike<number>,
  stride: number,
  corners: ArrayLike<number>,
  triangle: number,
  weights: readonly number[],
): number[] {
  return Array.from({ length: stride }, (_, k) =>
    weights.reduce((sum, weight, i) => sum + weight * values[stride * corners[3 * triangle + i] + k], 0),
  )
}

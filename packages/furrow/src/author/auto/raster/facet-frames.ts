import { triangleNormal } from '../../../math/triangle.ts'
import { cross, dot, length, normalize } from '../../../math/vector.ts'
import { skinVertices, triangleBox } from '../../skin/surface.ts'
import { reachOf } from '../../strokes/lay-out.ts'
import { LineGrid } from '../../strokes/line-grid.ts'
import { activationOf } from '../fit/fit-driver.ts'
import { type Pose, poseOf } from '../surface/pose.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'
import type { DrawnRegion } from './drawn-region.ts'
import { type Patch, patchOf } from './patch.ts'

// The matrices D, S and M in the comments below are described at `FacetFrames`.
/** Triangles within this fraction of a crease's reach are corrected. Farther away, slopes are too small to see. */
const NEAR = 0.6
/** Poses with a lower activation than this are ignored, because they do not show the crease. */
const MIN_ACTIVATION = 0.1
/**
 * Weight of the term that keeps the matrix M near the identity. Without the term, slopes could be infinite if the smooth normal lies in the
 * facet's plane.
 */
const RIDGE = 0.02
/** Triangles whose bounding box is smaller than this, in millimetres, need no correction, because a crease spans many of them. */
const FINE = 0.5
/**
 * Maximum product of a region's poses and the triangles near its lines. A region can exceed the limit where layers of skin overlap. Its creases
 * are then not corrected.
 */
const MAX_POSED = 500_000
/** Count of numbers per triangle corner: elements 00, 01 and 11 of `transpose(D) * D`, then all elements of `transpose(D) * S`. */
const STRIDE = 7
/** Count of numbers per triangle: for each corner, the elements of the 2 x 2 matrix M. */
const TURN = 12
const NONE = -1

type Skin = Pick<PreparedSkin, 'skin' | 'surface' | 'offsets' | 'names' | 'find'>

/**
 * Makes creases continuous on coarse meshes without tangents. On these meshes, renderers compute the tangent frame of the normal map from
 * each deformed triangle, a facet (`derivative` in `TangentFrame`). Without a correction, creases would break at the edges of facets.
 *
 * The class multiplies the slopes in the normal map by a 2 x 2 matrix M. D is the frame of a facet and S the frame of the smooth surface,
 * both 3 x 2 matrices. M minimises the sum of `w * a^2 * |D * M - S|^2` over the poses that show the crease. Here, `a` is the activation in
 * a pose, and `w` is the weight of the pose. On fine meshes M is almost the identity, so they are not corrected.
 */
export class FacetFrames {
  /** Index of each triangle's matrices in `#turns`; `NONE` if the triangle is not corrected. */
  readonly #slots: Int32Array
  readonly #turns: Float64Array

  /** @param regions regions whose creases are drawn into the map. */
  constructor(skin: Skin, regions: readonly DrawnRegion[]) {
    this.#slots = new Int32Array(skin.surface.skinTriangles.length).fill(NONE)
    const near = regions.flatMap((region) => {
      const poses = posesOf(skin, region)
      const patch = patchOf(skin.skin, skin.surface, trianglesNear(skin, region), MAX_POSED / poses.length)
      return patch ? [{ patch, poses }] : []
    })
    let count = 0
    for (const { patch } of near)
      for (const triangle of patch.triangles.subarray(0, patch.wanted))
        if (this.#slots[triangle] === NONE) this.#slots[triangle] = count++
    const sums = new Float64Array(3 * STRIDE * count)
    for (const { patch, poses } of near) addPatch(sums, this.#slots, skin, patch, poses)
    this.#turns = new Float64Array(TURN * count)
    for (let corner = 0; corner < 3 * count; corner++) solve(sums, corner, this.#turns)
  }

  /**
   * Corrects x and y of a slope in place.
   *
   * @param barycentrics barycentric coordinates of the texel in the triangle. Negative coordinates count as 0.
   */
  turn(triangle: number, barycentrics: ArrayLike<number>, slope: Float64Array): void {
    const slot = this.#slots[triangle]
    if (!(slot >= 0)) return
    const turns = this.#turns
    const a = Math.max(0, barycentrics[0])
    const b = Math.max(0, barycentrics[1])
    const c = Math.max(0, barycentrics[2])
    const first = TURN * slot
    const m = (k: number) =>
      (a * turns[first + k] + b * turns[first + 4 + k] + c * turns[first + 8 + k]) / (a + b + c)
    // The green channel points against v.
    const x = slope[0]
    const y = -slope[1]
    slope[0] = m(0) * x + m(1) * y
    slope[1] = -(m(2) * x + m(3) * y)
  }
}

/** Adds the poses of a region to the normal equations for M. Each corner of each triangle near the region's lines has its own equations. */
function addPatch(
  sums: Float64Array,
  slots: Int32Array,
  skin: Skin,
  patch: Patch,
  poses: readonly WeightedPose[],
): void {
  const frames = new DeformedFrames(skin, patch)
  for (const { pose, weight } of poses) {
    frames.deform(pose)
    for (let t = 0; t < patch.wanted; t++) frames.add(t, weight, sums, 3 * STRIDE * slots[patch.triangles[t]])
  }
}

interface WeightedPose {
  pose: Pose
  weight: number
}

/**
 * Returns the poses to correct for: the region's cause, and one pose with each single target of the region's driver. The cause weighs as much
 * as all other poses together. For a region that joints fold, returns the pose at rest.
 */
function posesOf({ names, find }: Skin, { region, driver }: DrawnRegion): WeightedPose[] {
  if (!driver) return [{ pose: new Map(), weight: 1 }]
  const weightOf = new Map(driver.targets.map(({ name, weight = 1 }) => [names.indexOf(name), weight]))
  const poses: Pose[] = [
    poseOf(find, region.cause),
    ...[...weightOf].flatMap(([target, weight]) => (weight > 0 ? [new Map([[target, 1]])] : [])),
  ]
  return poses.flatMap((pose, i) => {
    const sum = [...pose].reduce((total, [target, weight]) => total + weight * (weightOf.get(target) ?? 0), 0)
    const activation = activationOf(sum)
    const weight = i === 0 ? poses.length - 1 : 1
    return activation < MIN_ACTIVATION ? [] : [{ pose, weight: weight * activation ** 2 }]
  })
}

function trianglesNear({ surface }: Skin, { creases }: DrawnRegion): number[] {
  const grid = new LineGrid(
    creases,
    creases.map((crease) => NEAR * reachOf(crease)),
  )
  const [low, high] = [new Float64Array(3), new Float64Array(3)]
  const near: number[] = []
  for (let triangle = 0; triangle < surface.skinTriangles.length; triangle++) {
    triangleBox(surface, triangle, low, high)
    const isFine = high[0] - low[0] < FINE && high[1] - low[1] < FINE && high[2] - low[2] < FINE
    if (!isFine && grid.isNear(low, high)) near.push(triangle)
  }
  return near
}

/** Computes dP/du and dP/dv of a deformed surface P(u, v), on facets and at vertices, and the normals of the surface. */
class DeformedFrames {
  readonly #skin: Skin
  readonly #patch: Patch
  readonly #points: Float64Array
  readonly #normals: Float64Array
  /** For each facet, dP/du and dP/dv; 0 if a facet has no area in UV space. */
  readonly #ofFacet: Float64Array
  /** For each vertex, dP/du and dP/dv. */
  readonly #ofVertex: Float64Array

  constructor(skin: Skin, patch: Patch) {
    this.#skin = skin
    this.#patch = patch
    const { triangles, points, vertices } = patch
    this.#points = new Float64Array(3 * points.length)
    this.#normals = new Float64Array(3 * points.length)
    this.#ofFacet = new Float64Array(6 * triangles.length)
    this.#ofVertex = new Float64Array(6 * vertices.length)
  }

  deform(pose: Pose): void {
    const { triangles, corners, cornerVertices } = this.#patch
    this.#movePoints(pose)
    this.#normals.fill(0)
    this.#ofVertex.fill(0)
    const normal = new Float64Array(3)
    for (let t = 0; t < triangles.length; t++) {
      const [a, b, c] = [corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]]
      triangleNormal(normal, this.#points, a, b, c)
      this.#differentiate(t)
      const area = length(normal)
      for (let k = 3 * t; k < 3 * t + 3; k++) {
        for (let i = 0; i < 3; i++) this.#normals[3 * corners[k] + i] += normal[i]
        for (let i = 0; i < 6; i++)
          this.#ofVertex[6 * cornerVertices[k] + i] += area * this.#ofFacet[6 * t + i]
      }
    }
    for (let i = 0; i < this.#normals.length; i += 3) normalize(this.#normals, i)
  }

  /** Adds the current pose to the normal equations for M at the corners of a facet. */
  add(t: number, weight: number, out: Float64Array, first: number): void {
    if (isZero(this.#ofFacet, 6 * t)) return
    const { corners, cornerVertices } = this.#patch
    for (let k = 0; k < 3; k++) {
      const normal = 3 * corners[3 * t + k]
      frameOf(this.#ofFacet, 6 * t, this.#normals, normal, dt, db)
      frameOf(this.#ofVertex, 6 * cornerVertices[3 * t + k], this.#normals, normal, st, sb)
      const i = first + STRIDE * k
      out[i] += weight * dot(dt, dt)
      out[i + 1] += weight * dot(dt, db)
      out[i + 2] += weight * dot(db, db)
      out[i + 3] += weight * dot(dt, st)
      out[i + 4] += weight * dot(dt, sb)
      out[i + 5] += weight * dot(db, st)
      out[i + 6] += weight * dot(db, sb)
    }
  }

  #movePoints(pose: Pose): void {
    const { surface, offsets } = this.#skin
    const { points } = this.#patch
    for (let i = 0; i < points.length; i++) {
      for (let k = 0; k < 3; k++) this.#points[3 * i + k] = surface.points[3 * points[i] + k]
    }
    for (const [target, weight] of pose) {
      const offset = offsets[target]
      for (let i = 0; i < points.length; i++)
        for (let k = 0; k < 3; k++) this.#points[3 * i + k] += weight * offset[3 * points[i] + k]
    }
  }

  #differentiate(t: number): void {
    const { triangles, corners } = this.#patch
    const { skin, surface } = this.#skin
    const [a, b, c] = skinVertices(skin, surface, triangles[t])
    const [p, q, r] = [3 * corners[3 * t], 3 * corners[3 * t + 1], 3 * corners[3 * t + 2]]
    const { uvs } = skin
    const [u1, v1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]]
    const [u2, v2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]]
    const det = u1 * v2 - u2 * v1
    const scale = Math.abs(det) < 1e-14 ? 0 : 1 / det
    for (let k = 0; k < 3; k++) {
      const e1 = this.#points[q + k] - this.#points[p + k]
      const e2 = this.#points[r + k] - this.#points[p + k]
      this.#ofFacet[6 * t + k] = (e1 * v2 - e2 * v1) * scale
      this.#ofFacet[6 * t + 3 + k] = (e2 * u1 - e1 * u2) * scale
    }
  }
}

/** Scratch: tangent and bitangent of a facet (D), and of the smooth surface (S). */
const [dt, db, st, sb] = [new Float64Array(3), new Float64Array(3), new Float64Array(3), new Float64Array(3)]

function isZero(derivatives: Float64Array, first: number): boolean {
  for (let i = first; i < first + 6; i++) if (derivatives[i] !== 0) return false
  return true
}

/**
 * Computes a tangent frame: the gradients of u and v in the plane perpendicular to a normal, both divided by the length of the longer one.
 *
 * @param first index of dP/du in `derivatives`. The next three numbers are dP/dv.
 * @param n index of the normal in `normals`.
 */
function frameOf(
  derivatives: Float64Array,
  first: number,
  normals: Float64Array,
  n: number,
  tangent: Float64Array,
  bitangent: Float64Array,
): void {
  cross(tangent, derivatives, normals, first + 3, n)
  cross(bitangent, normals, derivatives, n, first)
  const scale = 1 / (Math.max(length(tangent), length(bitangent)) || 1)
  for (let k = 0; k < 3; k++) {
    tangent[k] *= scale
    bitangent[k] *= scale
  }
}

/** Solves the normal equations `(transpose(D) * D + ridge * I) * M = transpose(D) * S + ridge * I` for M at a corner. */
function solve(sums: Float64Array, corner: number, out: Float64Array): void {
  const [s00, s01, s11, t00, t01, t10, t11] = sums.subarray(STRIDE * corner, STRIDE * (corner + 1))
  const ridge = RIDGE * (s00 + s11) || 1
  const [a, b, d] = [s00 + ridge, s01, s11 + ridge]
  const det = a * d - b * b
  out[4 * corner] = (d * (t00 + ridge) - b * t10) / det
  out[4 * corner + 1] = (d * t01 - b * (t11 + ridge)) / det
  out[4 * corner + 2] = (a * t10 - b * (t00 + ridge)) / det
  out[4 * corner + 3] = (a * (t11 + ridge) - b * t01) / det
}

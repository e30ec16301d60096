import { triangleNormal } from '../../../math/triangle.ts'
import { cross, dot, length, normalize } from '../../../math/vector.ts'
import { cornersOf, skinVertices } from '../../skin/surface.ts'
import { LineGrid } from '../../strokes/line-grid.ts'
import { activationOf, type FittedRegion } from '../fit/fit-driver.ts'
import { type Pose, poseOf } from '../surface/pose.ts'
import type { PreparedSkin } from '../surface/prepare-skin.ts'

/** Half widths of a valley from its middle within which its slopes show. */
const NEAR = 3
/** Activation below which a pose does not count. */
const MIN_ACTIVATION = 0.1
/** Weight of leaving slopes as they are, relative to that of the poses: keeps them finite on facets seen edge-on. */
const RIDGE = 0.02
/** Numbers per corner of a triangle: D^T D (00, 01, 11), then D^T S (00, 01, 10, 11). */
const STRIDE = 7

type Skin = Pick<PreparedSkin, 'skin' | 'surface' | 'offsets' | 'names' | 'find'>

/**
 * Makes creases whole on coarse meshes without tangents. There renderers take the frame of a normal map from each deformed facet by itself
 * (Schueler, see `TangentFrame`), so that a crease breaks wherever it runs from one facet to the next. The slopes are drawn such that these
 * frames D give what the frames S of the smooth surface would, in the poses that show the crease: M = argmin sum w a^2 |D M - S|^2, where a is
 * the activation in a pose and w its weight. On meshes finer than the creases M is close to 1.
 */
export class FacetFrames {
  /** M by triangle: row by row, for each of its corners. */
  readonly #turns = new Map<number, Float64Array>()

  /** @param regions those whose creases are drawn into one map. */
  constructor(skin: Skin, regions: readonly FittedRegion[]) {
    const sums = new Map<number, Float64Array>()
    for (const region of regions) addRegion(sums, skin, region)
    for (const [triangle, sum] of sums) this.#turns.set(triangle, solve(sum))
  }

  /**
   * Turns the x and y of a slope on the texture, in place.
   *
   * @param barycentrics in the triangle; those below 0, beyond its border, count as 0.
   */
  turn(triangle: number, barycentrics: ArrayLike<number>, slope: Float64Array): void {
    const turns = this.#turns.get(triangle)
    if (!turns) return
    const [a, b, c] = [0, 1, 2].map((k) => Math.max(0, barycentrics[k]))
    const m = (k: number) => (a * turns[k] + b * turns[4 + k] + c * turns[8 + k]) / (a + b + c)
    // The green channel points against v.
    const [x, y] = [slope[0], -slope[1]]
    slope[0] = m(0) * x + m(1) * y
    slope[1] = -(m(2) * x + m(3) * y)
  }
}

function addRegion(sums: Map<number, Float64Array>, skin: Skin, region: FittedRegion): void {
  const near = trianglesNear(skin, region)
  const ring = trianglesAround(skin, near)
  for (const { pose, weight } of posesOf(skin, region)) {
    const frames = new DeformedFrames(skin, ring, pose)
    for (const triangle of near) {
      const sum = sums.get(triangle) ?? new Float64Array(3 * STRIDE)
      sums.set(triangle, sum)
      frames.add(triangle, weight, sum)
    }
  }
}

/** The cause of a region, and each target of its driver alone; the cause weighs as much as all targets together. */
function posesOf({ names, find }: Skin, { region, driver }: FittedRegion) {
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

function trianglesNear({ surface }: Skin, { creases }: FittedRegion): number[] {
  const grid = new LineGrid(
    creases,
    creases.map(({ halfWidths }) => NEAR * halfWidths.reduce((a, b) => Math.max(a, b), 0)),
  )
  const { points, corners } = surface
  const [low, high] = [new Float64Array(3), new Float64Array(3)]
  const near: number[] = []
  for (let triangle = 0; triangle < corners.length / 3; triangle++) {
    const [a, b, c] = cornersOf(surface, triangle)
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(points[3 * a + k], points[3 * b + k], points[3 * c + k])
      high[k] = Math.max(points[3 * a + k], points[3 * b + k], points[3 * c + k])
    }
    if (grid.isNear(low, high)) near.push(triangle)
  }
  return near
}

/** The triangles that have a point in common with any of those given. */
function trianglesAround({ surface }: Skin, triangles: readonly number[]): number[] {
  const { corners, areas } = surface
  const touched = new Uint8Array(areas.length)
  for (const triangle of triangles) for (const point of cornersOf(surface, triangle)) touched[point] = 1
  const around: number[] = []
  for (let t = 0; t < corners.length; t += 3)
    if (touched[corners[t]] || touched[corners[t + 1]] || touched[corners[t + 2]]) around.push(t / 3)
  return around
}

/** dP/du and dP/dv of a pose's surface on facets and at vertices, and its normals. */
class DeformedFrames {
  readonly #skin: Skin
  /** x, y and z of dP/du, then of dP/dv. */
  readonly #ofFacet = new Map<number, Float64Array>()
  readonly #ofVertex = new Map<number, Float64Array>()
  readonly #normals = new Map<number, Float64Array>()

  constructor(skin: Skin, triangles: readonly number[], pose: Pose) {
    this.#skin = skin
    const points = deformedPoints(skin, triangles, pose)
    const normal = new Float64Array(3)
    for (const triangle of triangles) {
      const corners = cornersOf(skin.surface, triangle)
      triangleNormal(normal, points, ...corners)
      for (const point of corners) addTo(this.#normals, point, normal, 1)
      const derivatives = this.#derivatives(triangle, points)
      if (!derivatives) continue
      this.#ofFacet.set(triangle, derivatives)
      for (const vertex of skinVertices(skin.skin, skin.surface, triangle))
        addTo(this.#ofVertex, vertex, derivatives, length(normal))
    }
  }

  /** Adds a facet's part of the normal equations, at each of its corners. */
  add(triangle: number, weight: number, out: Float64Array): void {
    const { skin, surface } = this.#skin
    const facet = this.#ofFacet.get(triangle)
    if (!facet) return
    const vertices = skinVertices(skin, surface, triangle)
    for (const [k, point] of cornersOf(surface, triangle).entries()) {
      const around = this.#ofVertex.get(vertices[k])
      if (!around) continue
      const normal = Float64Array.from(this.#normals.get(point) ?? [])
      normalize(normal)
      const [dt, db] = frameOf(facet, normal)
      const [st, sb] = frameOf(around, normal)
      const parts = [
        dot(dt, dt),
        dot(dt, db),
        dot(db, db),
        dot(dt, st),
        dot(dt, sb),
        dot(db, st),
        dot(db, sb),
      ]
      for (const [i, part] of parts.entries()) out[STRIDE * k + i] += weight * part
    }
  }

  /** Undefined where the triangle has no area in the texture. */
  #derivatives(triangle: number, points: Float64Array): Float64Array | undefined {
    const { skin, surface } = this.#skin
    const [a, b, c] = skinVertices(skin, surface, triangle)
    const [p, q, r] = cornersOf(surface, triangle)
    const { uvs } = skin
    const [u1, v1] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]]
    const [u2, v2] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]]
    const det = u1 * v2 - u2 * v1
    if (Math.abs(det) < 1e-14) return undefined
    const out = new Float64Array(6)
    for (let k = 0; k < 3; k++) {
      const e1 = points[3 * q + k] - points[3 * p + k]
      const e2 = points[3 * r + k] - points[3 * p + k]
      out[k] = (e1 * v2 - e2 * v1) / det
      out[3 + k] = (e2 * u1 - e1 * u2) / det
    }
    return out
  }
}

/** Only those of the triangles are deformed. */
function deformedPoints({ surface, offsets }: Skin, triangles: readonly number[], pose: Pose): Float64Array {
  const out = Float64Array.from(surface.points)
  const points = new Set(triangles.flatMap((triangle) => cornersOf(surface, triangle)))
  for (const [target, weight] of pose) {
    for (const point of points)
      for (let i = 3 * point; i < 3 * point + 3; i++) out[i] += weight * offsets[target][i]
  }
  return out
}

function addTo(sums: Map<number, Float64Array>, key: number, values: Float64Array, weight: number): void {
  const sum = sums.get(key) ?? new Float64Array(values.length)
  for (const [i, value] of values.entries()) sum[i] += weight * value
  sums.set(key, sum)
}

/** The gradients of u and v in the plane at a right angle to a normal, both divided by the longer of the two. */
function frameOf(derivatives: Float64Array, normal: Float64Array): [Float64Array, Float64Array] {
  const [tangent, bitangent] = [new Float64Array(3), new Float64Array(3)]
  cross(tangent, derivatives.subarray(3), normal)
  cross(bitangent, normal, derivatives.subarray(0, 3))
  const scale = 1 / (Math.max(length(tangent), length(bitangent)) || 1)
  for (let k = 0; k < 3; k++) {
    tangent[k] *= scale
    bitangent[k] *= scale
  }
  return [tangent, bitangent]
}

/** M at each corner, of the normal equations (D^T D + r 1) M = D^T S + r 1. */
function solve(sum: Float64Array): Float64Array {
  const out = new Float64Array(12)
  for (let corner = 0; corner < 3; corner++) {
    const [s00, s01, s11, t00, t01, t10, t11] = sum.subarray(STRIDE * corner, STRIDE * (corner + 1))
    const ridge = RIDGE * (s00 + s11) || 1
    const [a, b, d] = [s00 + ridge, s01, s11 + ridge]
    const det = a * d - b * b
    const columns = [
      [t00 + ridge, t10],
      [t01, t11 + ridge],
    ]
    for (const [k, [x, y]] of columns.entries()) {
      out[4 * corner + k] = (d * x - b * y) / det
      out[4 * corner + 2 + k] = (a * y - b * x) / det
    }
  }
  return out
}

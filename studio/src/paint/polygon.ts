import { FurrowError, type GrayImage } from 'furrow'
import { crossOf, dot, type SkinSurface, smoothstep } from 'furrow/internal'
import { checkPaintable, type PaintMap } from './paint-map.ts'
import type { PaintSkin, SkinPoint } from './paint-skin.ts'
import { cover, type Painted } from './painted.ts'
import { skinPath } from './skin-path.ts'
import { cross, squaredDistance } from './vectors.ts'
import { type Sight, VisiblePlaces } from './visible-places.ts'

export interface PolygonBrush {
  mode: 'add' | 'remove'
  /** Width of the soft outline, millimetres, at least 0. */
  feather: number
  /** Coverage, 0..1. */
  opacity: number
  /** Whether to also paint the mirror image of the polygon. */
  mirror: boolean
}

/** Minimum projected area of a polygon, as a fraction of its squared perimeter. For a circle, the fraction is 0.08. */
const MIN_AREA = 1e-4
/** Minimum cosine of the angle between the normals of polygon and triangle. Excludes triangles inside the mouth, for example. */
const MIN_FACING = -0.3
/** Maximum feather, millimetres. */
const MAX_FEATHER = 150
const MAX_POINTS = 1000

/**
 * Paints the inside of a polygon on the skin. The weight falls by smoothstep from 1 at `feather / 2` inside the outline to 0 at
 * `feather / 2` outside it. Polygons in `strokes.json` have the same soft outline.
 *
 * The polygon and the points of the skin are projected along the polygon's mean normal. A point is inside if its projection is inside the
 * projected polygon, and if a chain of adjacent triangles that are also inside leads from the outline to the point. Unlike a flood fill, this
 * test cannot leak between the lips. It fails only for a polygon around the back of the head, but users cannot draw one in a single view.
 * Distances to the outline are straight, not measured over the skin.
 *
 * @param points at least three, in order.
 * @param sight visibility test. Without it, hidden skin is painted too.
 * @throws FurrowError if the points enclose no skin, a setting is out of range, or the image cannot be painted.
 */
export function paintPolygon(
  image: GrayImage,
  points: readonly SkinPoint[],
  brush: PolygonBrush,
  skin: PaintSkin,
  sight?: Sight,
): Painted {
  checkPaintable(image)
  check(points, brush)
  const map = skin.mapOf(image.width)
  const coverage = new Float32Array(image.data.length)
  const sides = brush.mirror ? [points, points.map(({ position }) => skin.mirrored(position))] : [points]
  for (const [side, corners] of sides.entries()) {
    const seen = sight && new VisiblePlaces(skin, map, sight, side === 1)
    visitInside(
      skin.surface,
      map,
      new Outline(skin.surface, corners),
      brush.feather,
      (place, triangle, weight) => {
        const texel = map.texels[place]
        const value = weight * brush.opacity
        if (value > coverage[texel] && (seen?.has(place, triangle) ?? true)) coverage[texel] = value
      },
    )
  }
  return cover(image, coverage, brush.mode)
}

/**
 * Visits the texels inside a polygon, beginning at its outline and continuing to adjacent triangles. In the code, a place is a pair of a texel and a
 * triangle that contains it; see `PaintMapArrays`.
 */
function visitInside(
  surface: SkinSurface,
  map: PaintMap,
  outline: Outline,
  feather: number,
  visit: (place: number, triangle: number, weight: number) => void,
): void {
  const position = new Float64Array(3)
  const visited = new Set(outline.triangles)
  for (const triangle of visited) {
    const { centre, radius } = boundingSphere(surface, triangle)
    const isTouched = outline.segmentsNear(centre, radius + feather / 2).length > 0
    if (!isTouched && !(outline.contains(centre) && outline.isFacing(surface, triangle))) continue
    const [first, end] = [map.starts[triangle], map.starts[triangle + 1]]
    // Texels beyond a UV island can be outside the bounding sphere.
    let reach = radius
    for (let place = first; place < end; place++) {
      reach = Math.max(reach, Math.sqrt(squaredDistance(map.positions, 3 * place, 3 * place, centre)))
    }
    const near = outline.segmentsNear(centre, reach + feather / 2)
    for (let place = first; place < end; place++) {
      for (let k = 0; k < 3; k++) position[k] = map.positions[3 * place + k]
      const weight = near.length === 0 ? 1 : outline.weightAt(position, near, feather)
      if (weight > 0) visit(place, triangle, weight)
    }
    for (let k = 0; k < 3; k++) {
      const next = surface.adjacent[3 * triangle + k]
      if (next >= 0) visited.add(next)
    }
  }
}

/** Returns the centroid of a triangle and the distance to its farthest corner. */
function boundingSphere({ points, corners }: SkinSurface, triangle: number) {
  const centre = new Float64Array(3)
  for (let i = 0; i < 9; i++)
    centre[i % 3] += points[3 * corners[3 * triangle + Math.floor(i / 3)] + (i % 3)] / 3
  const distances = [0, 1, 2].map((k) => {
    const corner = 3 * corners[3 * triangle + k]
    return squaredDistance(points, corner, corner, centre)
  })
  return { centre, radius: Math.sqrt(Math.max(...distances)) }
}

/** Closed outline of a polygon on the skin. */
class Outline {
  readonly triangles: ReadonlySet<number>
  /** Packed xyz per point. The first point is repeated at the end. */
  readonly #points: Float64Array
  /** Unit vectors: the polygon's mean normal, pointing out of the skin, and two tangents. */
  readonly #axes: readonly [front: Float64Array, across: Float64Array, up: Float64Array]
  /** Coordinates of the points along the two tangents. */
  readonly #flat: readonly (readonly [number, number])[]

  constructor(surface: SkinSurface, corners: readonly SkinPoint[]) {
    const path = corners.flatMap((from, i) => {
      const to = corners[(i + 1) % corners.length]
      return (skinPath(surface, from, to) ?? [from, to]).slice(0, -1)
    })
    this.triangles = new Set(path.map(({ triangle }) => triangle))
    const step = Math.ceil(path.length / MAX_POINTS)
    const points = [...path.filter((_, i) => i % step === 0), path[0]]
    this.#points = Float64Array.from(points.flatMap(({ position }) => [...position]))
    this.#axes = this.#findAxes(surface)
    this.#flat = points.map(({ position }) => this.#flatten(position))
  }

  /** Returns the offsets in `#points` of the segments that are nearer to a position than `distance`. */
  segmentsNear(position: Float64Array, distance: number): number[] {
    const near: number[] = []
    for (let i = 0; i + 3 < this.#points.length; i += 3) {
      if (squaredDistance(this.#points, i, i + 3, position) < distance * distance) near.push(i)
    }
    return near
  }

  /** Whether a position, projected along the mean normal, is inside the polygon. Uses the even-odd rule. */
  contains(position: ArrayLike<number>): boolean {
    const [x, y] = this.#flatten(position)
    let isInside = false
    for (let i = 1; i < this.#flat.length; i++) {
      const [[x0, y0], [x1, y1]] = [this.#flat[i - 1], this.#flat[i]]
      if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) isInside = !isInside
    }
    return isInside
  }

  /** Returns the weight at a position, 0..1. @param near result of `segmentsNear`, not empty. */
  weightAt(position: Float64Array, near: readonly number[], feather: number): number {
    const isInside = this.contains(position)
    let square = Infinity
    for (const i of near) square = Math.min(square, squaredDistance(this.#points, i, i + 3, position))
    const distance = Math.sqrt(square)
    if (distance >= feather / 2) return isInside ? 1 : 0
    return 1 - smoothstep((isInside ? -distance : distance) / feather + 0.5)
  }

  isFacing({ points, corners }: SkinSurface, triangle: number): boolean {
    const normal = new Float64Array(3)
    const [a, b, c] = corners.subarray(3 * triangle, 3 * triangle + 3)
    const length = crossOf(points, a, b, c, normal)
    return dot(normal, this.#axes[0]) > MIN_FACING * length
  }

  #findAxes(surface: SkinSurface): [Float64Array, Float64Array, Float64Array] {
    const front = this.#meanNormal()
    const normal = new Float64Array(3)
    let facing = 0
    for (const triangle of this.triangles) {
      const [a, b, c] = surface.corners.subarray(3 * triangle, 3 * triangle + 3)
      crossOf(surface.points, a, b, c, normal)
      facing += dot(normal, front)
    }
    if (facing < 0) for (let k = 0; k < 3; k++) front[k] = -front[k]
    // The first tangent is perpendicular to the normal and to the coordinate axis of the normal's smallest component.
    const [x, y, z] = front.map(Math.abs)
    const axis = x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1]
    const across = cross(front, axis)
    const length = Math.hypot(...across)
    for (let k = 0; k < 3; k++) across[k] /= length
    return [front, across, cross(front, across)]
  }

  /** Computes the mean normal by Newell's method: the normalised sum of the cross products of consecutive points. */
  #meanNormal(): Float64Array {
    const [sum, points] = [new Float64Array(3), this.#points]
    let perimeter = 0
    for (let i = 0; i + 3 < points.length; i += 3) {
      const a = points.subarray(i, i + 3).map((value, k) => value - points[k])
      const b = points.subarray(i + 3, i + 6).map((value, k) => value - points[k])
      for (const [k, value] of cross(a, b).entries()) sum[k] += value / 2
      perimeter += Math.sqrt(squaredDistance(points, i, i, points.subarray(i + 3, i + 6)))
    }
    const area = Math.hypot(...sum)
    if (area > MIN_AREA * perimeter * perimeter) return sum.map((value) => value / area)
    throw new FurrowError({
      who: 'Studio',
      problem: 'the polygon encloses no skin',
      value: `${area.toFixed(1)} square millimetres`,
      remedy: 'draw it around the skin to paint',
    })
  }

  #flatten(position: ArrayLike<number>): [number, number] {
    return [dot(position, this.#axes[1]), dot(position, this.#axes[2])]
  }
}

function check(points: readonly SkinPoint[], { feather, opacity }: PolygonBrush): void {
  const fail = (problem: string, value: unknown, limit: string, remedy: string) => {
    throw new FurrowError({ code: 'out-of-range', who: 'Studio', problem, value, limit, remedy })
  }
  if (points.length < 3) fail('a polygon has too few points', points.length, 'at least 3', 'add points')
  if (!(feather >= 0 && feather <= MAX_FEATHER)) {
    fail(
      'the feather of a polygon is out of range',
      feather,
      `0 to ${MAX_FEATHER} mm`,
      'choose a value in this range',
    )
  }
  if (!(opacity >= 0 && opacity <= 1))
    fail('the opacity of a polygon is out of range', opacity, '0 to 1', 'choose a value in this range')
}

import { type Camera, Vector3 } from 'three'
import type { LayerStroke } from '../document/document.ts'
import type { Sight } from '../paint/visible-places.ts'
import type { LineSkin } from './line-skin.ts'

/** Line in screen space. */
export interface ProjectedLine {
  readonly stroke: LayerStroke
  /** Screen coordinates per point, CSS pixels from the stage's upper left corner. */
  readonly x: Float32Array
  readonly y: Float32Array
  /** Visibility per point. */
  readonly isSeen: readonly boolean[]
  /** Position along the line per point, 0..1. */
  readonly along: Float64Array
  /** Indices of the spline points. */
  readonly knots: readonly number[]
}

/** Point of a line under the pointer. */
export interface LineHit {
  readonly stroke: LayerStroke
  readonly along: number
  /** Distance to the pointer, CSS pixels. */
  readonly distance: number
}

/** Interval of visibility tests, points (2 mm). */
const SIGHT_STEP = 4

/** Projects lines on the deformed face to the stage. Cached until the camera or the face moves. */
export class LineProjection {
  /** Inputs of the cached projections. */
  #view: readonly unknown[] = []
  #lines = new WeakMap<LayerStroke, ProjectedLine | null>()

  /** @param size stage size, CSS pixels. */
  project(
    strokes: readonly LayerStroke[],
    skin: LineSkin,
    camera: Camera,
    size: readonly [width: number, height: number],
  ): ProjectedLine[] {
    camera.updateMatrixWorld()
    skin.follow()
    const matrices = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements]
    const view = [skin, skin.picker.poses, ...size, ...matrices]
    if (view.some((value, i) => value !== this.#view[i])) {
      this.#view = view
      this.#lines = new WeakMap()
    }
    const sight = skin.picker.sightFrom(new Vector3().setFromMatrixPosition(camera.matrixWorld))
    return strokes.flatMap((stroke) => {
      const known = this.#lines.get(stroke)
      if (known !== undefined) return known ?? []
      const line = projectLine(stroke, skin, sight, camera, size)
      this.#lines.set(stroke, line)
      return line ?? []
    })
  }
}

/** Returns null if the line misses the skin. */
function projectLine(
  stroke: LayerStroke,
  skin: LineSkin,
  sight: Sight,
  camera: Camera,
  [width, height]: readonly [width: number, height: number],
): ProjectedLine | null {
  const line = skin.lineOf(stroke)
  if (!line) return null
  const { triangles, weights, along, knots } = line
  const point = new Vector3()
  const [x, y] = [new Float32Array(along.length), new Float32Array(along.length)]
  const isSeen: boolean[] = []
  for (const [i, triangle] of triangles.entries()) {
    const own = weights.subarray(3 * i, 3 * i + 3)
    skin.picker.positionOf(triangle, own, point).project(camera)
    x[i] = (0.5 + point.x / 2) * width
    y[i] = (0.5 - point.y / 2) * height
    isSeen.push(i % SIGHT_STEP === 0 || i === along.length - 1 ? sight(triangle, own) : isSeen[i - 1])
  }
  return { stroke, x, y, isSeen, along, knots }
}

/** Finds the visible line nearest to a point of the stage, within a distance. */
export function nearestLine(
  lines: readonly ProjectedLine[],
  px: number,
  py: number,
  within: number,
): LineHit | undefined {
  let nearest: LineHit | undefined
  for (const { stroke, x, y, isSeen, along } of lines) {
    for (let i = 0; i + 1 < along.length; i++) {
      if (!isSeen[i]) continue
      const [dx, dy] = [x[i + 1] - x[i], y[i + 1] - y[i]]
      const t = Math.min(1, Math.max(0, ((px - x[i]) * dx + (py - y[i]) * dy) / (dx * dx + dy * dy || 1)))
      const distance = Math.hypot(x[i] + t * dx - px, y[i] + t * dy - py)
      if (distance > (nearest?.distance ?? within)) continue
      nearest = { stroke, along: along[i] + t * (along[i + 1] - along[i]), distance }
    }
  }
  return nearest
}

/** Finds the spline point nearest to a point of the stage, within a distance. Returns -1 if there is none. */
export function nearestKnot({ x, y, knots }: ProjectedLine, px: number, py: number, within: number): number {
  let [nearest, least] = [-1, within]
  for (const [index, i] of knots.entries()) {
    const distance = Math.hypot(x[i] - px, y[i] - py)
    if (distance > least) continue
    nearest = index
    least = distance
  }
  return nearest
}

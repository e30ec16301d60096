import type { Fork } from 'furrow/internal'
import { type Camera, Vector3 } from 'three'
import type { LayerStroke } from '../document/document.ts'
import type { Sight } from '../paint/visible-places.ts'
import type { Handle } from './handles.ts'
import type { LineSkin } from './line-skin.ts'

/** Wrinkle line as a polyline in screen space. */
export interface ProjectedLine {
  readonly stroke: LayerStroke
  /** Coordinates of each point, CSS pixels from the stage's upper left corner. */
  readonly x: Float32Array
  readonly y: Float32Array
  /** Whether the camera sees each point. */
  readonly isSeen: readonly boolean[]
  /** Position of each point along the line, 0..1. */
  readonly along: Float64Array
}

/** Visible fork in screen space. */
export interface ProjectedFork {
  readonly fork: Fork
  /** CSS pixels from the stage's upper left corner. */
  readonly x: number
  readonly y: number
}

/** Point of a line under the pointer. */
export interface LineHit {
  readonly stroke: LayerStroke
  /** Position along the line, 0..1. */
  readonly along: number
  /** Distance to the pointer, CSS pixels. */
  readonly distance: number
}

/** Visibility is tested at every fourth point of a line. Most tested points are at most 2 mm apart. The points between take the last result. */
const SIGHT_STEP = 4

/** Projects the lines of the deformed face to screen space. Caches the result until the camera or the face moves. */
export class LineProjection {
  /** Pose, stage size and camera of the cached projections. */
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

/** Projects one line. Returns null if the line is not on the skin. */
function projectLine(
  stroke: LayerStroke,
  skin: LineSkin,
  sight: Sight,
  camera: Camera,
  [width, height]: readonly [width: number, height: number],
): ProjectedLine | null {
  const line = skin.lineOf(stroke)
  if (!line) return null
  const { triangles, weights, along } = line
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
  return { stroke, x, y, isSeen, along }
}

/** Finds the visible line nearest to a stage position, at most `within` CSS pixels away. */
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

/** Finds the index of the handle nearest to a point of the stage, at most `within` CSS pixels away. Returns -1 if there is none. */
export function nearestHandle(
  { x, y }: ProjectedLine,
  handles: readonly Handle[],
  px: number,
  py: number,
  within: number,
): number {
  return nearestOf(
    handles.map(({ place }) => ({ x: x[place], y: y[place] })),
    px,
    py,
    within,
  )
}

/** Finds the fork nearest to a point of the stage, at most `within` CSS pixels away. */
export function nearestFork(
  forks: readonly ProjectedFork[],
  px: number,
  py: number,
  within: number,
): Fork | undefined {
  return forks[nearestOf(forks, px, py, within)]?.fork
}

/** Returns the visible forks of lines. @param strokes strokes of the document, which `forks` refer to by their indices. */
export function projectForks(
  forks: readonly Fork[],
  strokes: readonly LayerStroke[],
  lines: readonly ProjectedLine[],
): ProjectedFork[] {
  const lineOf = new Map(lines.map((line) => [line.stroke, line]))
  return forks.flatMap((fork) => {
    const [{ stroke, end }] = fork.ends
    const line = lineOf.get(strokes[stroke])
    if (!line) return []
    const i = end * (line.x.length - 1)
    return line.isSeen[i] ? [{ fork, x: line.x[i], y: line.y[i] }] : []
  })
}

function nearestOf(
  points: readonly { readonly x: number; readonly y: number }[],
  px: number,
  py: number,
  within: number,
): number {
  let [nearest, least] = [-1, within]
  for (const [index, { x, y }] of points.entries()) {
    const distance = Math.hypot(x - px, y - py)
    if (distance > least) continue
    nearest = index
    least = distance
  }
  return nearest
}

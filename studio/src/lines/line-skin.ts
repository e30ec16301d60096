import { type Skin, type SkinCanvas, skinCanvas } from 'furrow/author'
import { barycentricsAt, knotsOf, type MirrorPlane, middleOf, splineOf, traceStroke } from 'furrow/internal'
import type { Mesh } from 'three'
import type { LayerStroke } from '../document/document.ts'
import { makeCanvasInWorker } from '../paint/in-worker.ts'
import type { SkinPicker } from '../paint/picker.ts'
import { type PosedSkin, prepareSkin } from '../paint/posed-skin.ts'

/** Stroke as a polyline bound to the skin's triangles, so that it follows deformation. */
export interface SkinLine {
  /** Triangle and barycentric coordinates per point. */
  triangles: readonly number[]
  weights: Float64Array
  /** Position along the line per point, 0..1. */
  along: Float64Array
  /** Index of the polyline point at each spline point. */
  knots: readonly number[]
}

/** Skin of a face, prepared for drawing lines. */
export class LineSkin {
  /** Canvas with texels of the document's areas. */
  readonly canvas: SkinCanvas
  readonly #posed: PosedSkin
  readonly #lines = new WeakMap<LayerStroke, SkinLine | null>()

  /** @param canvas canvas of the same skin. */
  constructor(posed: PosedSkin, canvas: SkinCanvas) {
    this.#posed = posed
    this.canvas = canvas
  }

  get picker(): SkinPicker {
    return this.#posed.picker
  }

  /** Plane between left and right half. Undefined if blendshapes do not define it. */
  get middle(): MirrorPlane | undefined {
    return middleOf(this.#skin)
  }

  /** Follows the pose. */
  follow(): void {
    this.#posed.follow()
  }

  get #skin(): Skin {
    return this.#posed.skin.skin
  }

  /** Returns the cached polyline of a stroke, or null if the stroke misses the skin. */
  lineOf(stroke: LayerStroke): SkinLine | null {
    const known = this.#lines.get(stroke)
    if (known !== undefined) return known
    const line = this.#trace(stroke)
    this.#lines.set(stroke, line)
    return line
  }

  #trace(stroke: LayerStroke): SkinLine | null {
    const spline = splineOf(stroke, this.canvas)
    const traced = traceStroke(spline, this.canvas)
    const { points, triangles, lengths } = traced
    if (triangles.length === 0) return null
    const weights = new Float64Array(points.length)
    const own = new Float64Array(3)
    for (const [i, triangle] of triangles.entries()) {
      barycentricsAt(own, this.canvas.surface, triangle, points.subarray(3 * i, 3 * i + 3))
      weights.set(own, 3 * i)
    }
    const length = lengths[lengths.length - 1]
    return {
      triangles,
      weights,
      along: lengths.map((each) => each / length),
      knots: knotsOf(spline, traced, this.canvas),
    }
  }
}

/**
 * Prepares a skin for drawing lines, in workers, or on the main thread if a worker dies. Rejects with a FurrowError if that fails.
 *
 * @param size side of the face's areas, texels.
 */
export async function readLineSkin(
  meshes: readonly [Mesh, ...Mesh[]],
  scale: number,
  size: number,
): Promise<LineSkin> {
  const posed = await prepareSkin(meshes, scale, size)
  const { positions, uvs, indices } = posed.skin.skin
  const mesh = { positions, uvs, indices }
  const canvas = await makeCanvasInWorker(mesh, size, scale).catch(() => skinCanvas(mesh, size, size, scale))
  return new LineSkin(posed, canvas)
}

import { type Skin, type SkinCanvas, skinCanvas } from 'furrow/author'
import { barycentricsAt, knotsOf, type MirrorPlane, middleOf, splineOf, traceStroke } from 'furrow/internal'
import type { Mesh } from 'three'
import type { LayerStroke } from '../document/document.ts'
import { makeCanvasInWorker } from '../paint/in-worker.ts'
import type { SkinPicker } from '../paint/picker.ts'
import { type PosedSkin, prepareSkin } from '../paint/posed-skin.ts'

/** A stroke as a line on the skin, which follows the skin when that is deformed. */
export interface SkinLine {
  /** The triangle that each point is on, and its three barycentric coordinates in it. */
  triangles: readonly number[]
  weights: Float64Array
  /** How far along the line each point is, as a fraction of its length, 0..1. */
  along: Float64Array
  /** For each point of the stroke as a spline, the point of the line there. */
  knots: readonly number[]
}

/** The skin of a face as lines are drawn on it. */
export class LineSkin {
  /** With texels of the document's areas. */
  readonly canvas: SkinCanvas
  readonly #posed: PosedSkin
  readonly #lines = new WeakMap<LayerStroke, SkinLine | null>()

  /** @param canvas of the same skin. */
  constructor(posed: PosedSkin, canvas: SkinCanvas) {
    this.#posed = posed
    this.canvas = canvas
  }

  get picker(): SkinPicker {
    return this.#posed.picker
  }

  /** Between the left and right half; undefined where blendshapes do not show it. */
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

  /** The line of a stroke, found once; null where none of it is on the skin. */
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
 * Makes the skin of a face ready to be drawn on, in workers; on the page where they end. It rejects with a FurrowError where it cannot be drawn on.
 *
 * @param size side of the face's areas in texels.
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

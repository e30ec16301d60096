import { type Skin, type SkinCanvas, skinCanvas } from 'furrow/author'
import { barycentricsAt, type MirrorPlane, StrokeLines, uvOf } from 'furrow/internal'
import type { Mesh } from 'three'
import type { LayerStroke } from '../document/document.ts'
import { makeCanvasInWorker } from '../paint/in-worker.ts'
import type { SkinPicker } from '../paint/picker.ts'
import { type PosedSkin, prepareSkin } from '../paint/posed-skin.ts'
import { TexturePicker } from '../tools/texture-picker.ts'

/** Wrinkle line as a polyline. Its points are fixed to triangles of the skin, so that the line follows the deformed skin. */
export interface SkinLine {
  /** Triangle of each point. */
  triangles: readonly number[]
  /** Three barycentric coordinates of each point in its triangle. */
  weights: Float64Array
  /** Position of each point along the line, 0..1. */
  along: Float64Array
}

/** Skin of a face, prepared for drawing lines. */
export class LineSkin {
  /** Texels of the skin, with the resolution of the document's areas. */
  readonly canvas: SkinCanvas
  readonly lines: StrokeLines
  readonly #posed: PosedSkin
  readonly #middleOf: (skin: Skin) => MirrorPlane | undefined
  readonly #skinLines = new WeakMap<LayerStroke, SkinLine | null>()
  readonly #uvs = new WeakMap<LayerStroke, Float64Array>()

  /** @param middleOf finds the plane between the two halves of a face. */
  constructor(posed: PosedSkin, canvas: SkinCanvas, middleOf: (skin: Skin) => MirrorPlane | undefined) {
    this.#posed = posed
    this.#middleOf = middleOf
    this.canvas = canvas
    this.lines = new StrokeLines(canvas)
  }

  get picker(): SkinPicker {
    return this.#posed.picker
  }

  /** Finds the point of the skin under the pointer in the view of the texture. */
  get texturePicker(): TexturePicker {
    const { skin, picker } = this.#posed
    return new TexturePicker(skin, picker, this.canvas.metric.width)
  }

  /** Plane between the left and the right half of the face. Undefined if it cannot be found from the motion of the blendshapes. */
  get middle(): MirrorPlane | undefined {
    return this.#middleOf(this.#skin)
  }

  /** Updates the skin to the current pose of the face. */
  follow(): void {
    this.#posed.follow()
  }

  get #skin(): Skin {
    return this.#posed.skin.skin
  }

  /** Returns the polyline of a stroke and caches it. Returns null if the stroke is not on the skin. */
  lineOf(stroke: LayerStroke): SkinLine | null {
    const known = this.#skinLines.get(stroke)
    if (known !== undefined) return known
    const line = this.#lineOf(stroke)
    this.#skinLines.set(stroke, line)
    return line
  }

  /** Returns `u, v` of each point of a stroke's polyline, packed, and caches them. Returns null if the stroke is not on the skin. */
  uvsOf(stroke: LayerStroke): Float64Array | null {
    const line = this.lines.lineOf(stroke)
    if (!line) return null
    const known = this.#uvs.get(stroke)
    if (known) return known
    const uvs = Float64Array.from(line.triangles.flatMap((_, i) => uvOf(line, i, this.canvas)))
    this.#uvs.set(stroke, uvs)
    return uvs
  }

  #lineOf(stroke: LayerStroke): SkinLine | null {
    const line = this.lines.lineOf(stroke)
    if (!line) return null
    const { points, triangles, lengths } = line
    const weights = new Float64Array(points.length)
    const own = new Float64Array(3)
    for (const [i, triangle] of triangles.entries()) {
      barycentricsAt(own, this.canvas.surface, triangle, points.subarray(3 * i, 3 * i + 3))
      weights.set(own, 3 * i)
    }
    const length = lengths[lengths.length - 1]
    return { triangles, weights, along: lengths.map((each) => each / length) }
  }
}

/**
 * Prepares a skin for drawing lines. Uses workers, or the main thread if a worker dies. Rejects with a FurrowError if the skin
 * cannot be painted.
 *
 * @param size width and height of the document's areas, texels.
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
  const { middleOf } = await import('./middle.ts')
  return new LineSkin(posed, canvas, middleOf)
}

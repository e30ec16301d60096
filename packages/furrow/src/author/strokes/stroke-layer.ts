import { type Bounds, grown } from '../../core/bounds.ts'
import { checkSizes, overlayNormals } from '../../core/normals/combine-normals.ts'
import type { GrayImage, RgbaImage } from '../../core/types.ts'
import { drawNormals, heightToNormal, type TangentFrame } from '../normals/height-to-normal.ts'
import { SLOPE_REACH } from '../normals/slope.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import { ChangedTexels, mergeBounds } from './changed-texels.ts'
import type { Stroke } from './document.ts'
import { type DrawnStrokes, flatSkin, type HeightMap, StrokePen } from './height.ts'
import { layOutStroke } from './lay-out.ts'
import { OnsetLayer } from './onset-layer.ts'
import { OtherStrokes } from './other-strokes.ts'
import { gridOf, laidOf, overlap, type PlacedStroke, placeOf } from './placed-stroke.ts'
import { SculptedSum } from './sculpted-sum.ts'

/** Options of a `StrokeLayer`. */
export interface StrokeLayerOptions {
  /**
   * Normal map of the skin without wrinkles, for example with pores and scars. It must have the canvas's size. The layer keeps a reference
   * and does not change the map. Default: flat skin.
   */
  base?: RgbaImage
  /** Tangent frame of the normal map; default `orthonormal`. */
  frame?: TangentFrame
  /** Whether to draw the onset map; default false. */
  onset?: boolean
}

/**
 * Height, occlusion, normal and optionally onset map of strokes (wrinkles), with optional sculpted heights. When the strokes change, only the
 * skin within reach of added, removed or replaced strokes is redrawn. While the same stroke is edited repeatedly, the contributions of all
 * other strokes are cached; `prepare` fills this cache before the first edit. Results are bit-identical to a full redraw with `strokesToHeight`, `heightToNormal`, `combineNormals` and
 * `strokesToOnset`.
 *
 * Memory: 10 bytes per texel (14 with sculpted heights), 64 bytes per half millimetre of stroke, and up to 32 MB while one stroke is edited.
 * Layers with maps of the same size can share a canvas.
 */
export class StrokeLayer {
  /** 255 = unoccluded. `draw` and `sculpt` change this map and the other maps in place. */
  readonly occlusion: GrayImage
  /** Tangent-space normal map of wrinkles and base, in the encoding of `heightToNormal`. */
  readonly normal: RgbaImage
  /** Onset map, see `strokesToOnset`. Undefined without the option `onset`. */
  readonly onset: GrayImage | undefined
  readonly #canvas: SkinCanvas
  readonly #base: RgbaImage | undefined
  readonly #frame: TangentFrame
  readonly #drawn: DrawnStrokes
  readonly #onset: OnsetLayer | undefined
  #sculpted: SculptedSum | undefined
  #strokes: readonly PlacedStroke[] = []
  /** Cache for the stroke that is being edited. Null if the last change involved several strokes. */
  #edit: Edit | null = null

  /**
   * Creates a layer without strokes.
   *
   * @throws FurrowError if `base` does not have the canvas's size.
   */
  constructor(canvas: SkinCanvas, { base, frame = 'orthonormal', onset = false }: StrokeLayerOptions = {}) {
    const { metric } = canvas
    this.#canvas = canvas
    this.#base = base
    this.#frame = frame
    this.#drawn = flatSkin(metric.width, metric.height)
    this.occlusion = this.#drawn.occlusion
    this.normal = heightToNormal(this.heights, metric, frame)
    this.#onset = onset ? new OnsetLayer(canvas) : undefined
    this.onset = this.#onset?.map
    if (!base) return
    checkSizes(base, this.normal)
    overlayNormals(base, this.normal, this.#whole)
  }

  /** Heights of strokes and sculpted heights. The object changes when the layer gets its first sculpted heights, or loses them. */
  get heights(): HeightMap {
    return this.#sculpted?.heights ?? this.#drawn.heights
  }

  /**
   * Updates the maps to a new list of strokes. Strokes are compared by identity, so an edit must replace the stroke's object. Reordered
   * strokes count as changed.
   *
   * @returns changed rectangles in texels. There are several if changes are far apart, for example on both sides of a UV seam.
   */
  draw(strokes: readonly Stroke[]): Bounds[] {
    const { placed, changed } = this.#place(strokes)
    if (changed.length === 0) return []
    this.#edit = this.#editTo(placed)
    this.#strokes = placed
    const touched = gridOf(changed)
    const pen = this.#edit ? this.#penForEdit(this.#edit) : this.#penFor(changed)
    const texels = new ChangedTexels(this.heights.width, this.heights.height)
    this.#canvas.texels.visitNear(touched.isNear, (texel, position, normal) => {
      if (touched.isWithinReach(position) && pen.draw(texel, position, normal)) texels.add(texel)
    })
    const bounds = texels.around(SLOPE_REACH)
    this.#sculpted?.update(bounds)
    for (const each of bounds) this.#drawNormals(each)
    return mergeBounds([...bounds, ...(this.#onset?.draw(placed, changed) ?? [])])
  }

  /**
   * Adds sculpted heights to those of the strokes, see `sculptedHeight`. Later calls of `draw` keep them. Occlusion and onset do not change.
   *
   * @param sculpted heights in millimetres. The layer keeps a reference. Null removes them.
   * @param changed rectangle outside which no height has changed since the last call. Default: the whole map.
   * @returns redrawn rectangle in texels.
   * @throws FurrowError if the heights do not have the canvas's size.
   */
  sculpt(sculpted: HeightMap | null, changed: Bounds = this.#whole): Bounds {
    const isOther = sculpted !== (this.#sculpted?.sculpted ?? null)
    if (isOther) this.#sculpted = sculpted ? new SculptedSum(this.#drawn.heights, sculpted) : undefined
    this.#sculpted?.update([isOther ? this.#whole : changed])
    const bounds = grown(changed, SLOPE_REACH, this.#whole)
    this.#drawNormals(bounds)
    return bounds
  }

  /**
   * Prepares the edit of a stroke: caches the contributions of all other strokes within the stroke's reach. Without this call, `draw` fills
   * the cache when the stroke is first replaced or removed.
   *
   * @returns generator that processes 64 texels per step. The caller may call `draw` between steps. The generator ends early if another
   *   stroke is prepared or edited.
   */
  *prepare(stroke: Stroke): Generator<void, void> {
    const index = this.#strokes.findIndex((each) => each.stroke === stroke)
    if (index < 0) return
    if (this.#edit?.before.length !== index || this.#edit.after.length !== this.#strokes.length - index - 1)
      this.#edit = this.#editOf(this.#strokes.slice(0, index), this.#strokes.slice(index + 1))
    const edit = this.#edit
    const near = gridOf([this.#strokes[index]])
    const steps = this.#canvas.texels.visitNearInSteps(near.isNear, (texel, position, normal) => {
      if (near.isWithinReach(position)) edit.others.hold(texel, position, normal)
    })
    for (const _ of steps) {
      yield
      if (this.#edit !== edit) return
    }
  }

  /** Returns the edit that changes `#strokes` to `placed`, or null if more than one stroke was added, removed or replaced. */
  #editTo(placed: readonly PlacedStroke[]): Edit | null {
    if (this.#edit && matchesEdit(placed, this.#edit)) return this.#edit
    const old = this.#strokes
    const shorter = Math.min(old.length, placed.length)
    let [same, sameAtEnd] = [0, 0]
    while (same < shorter && old[same] === placed[same]) same++
    while (sameAtEnd < shorter - same && old.at(-1 - sameAtEnd) === placed.at(-1 - sameAtEnd)) sameAtEnd++
    if (Math.max(old.length, placed.length) - same - sameAtEnd > 1) return null
    return this.#editOf(placed.slice(0, same), placed.slice(placed.length - sameAtEnd))
  }

  #editOf(before: readonly PlacedStroke[], after: readonly PlacedStroke[]): Edit {
    const others = new OtherStrokes(laidOf(before), laidOf(after), this.#canvas.metric)
    return { before, after, others }
  }

  #penFor(changed: readonly PlacedStroke[]): StrokePen {
    // Redrawing a texel within reach of a changed stroke requires all strokes that reach this texel.
    const near = this.#strokes.filter(({ box }) => changed.some((other) => overlap(box, other.box)))
    return new StrokePen(laidOf(near), this.#canvas.metric, this.#drawn)
  }

  #penForEdit({ before, after, others }: Edit): StrokePen {
    const own = this.#strokes.slice(before.length, this.#strokes.length - after.length)
    return new StrokePen(laidOf(own), this.#canvas.metric, this.#drawn, others)
  }

  /** Lays new strokes on the skin. Returns all strokes, and the strokes that were added or removed. */
  #place(strokes: readonly Stroke[]): { placed: PlacedStroke[]; changed: PlacedStroke[] } {
    const indices = new Map<Stroke, number[]>()
    for (const [i, { stroke }] of this.#strokes.entries())
      indices.set(stroke, [...(indices.get(stroke) ?? []), i])
    const removed = new Set(this.#strokes)
    const added: PlacedStroke[] = []
    let last = -1
    const placed = strokes.map((stroke) => {
      const index = indices.get(stroke)?.find((i) => i > last)
      if (index === undefined) {
        const own = { stroke, ...placeOf(layOutStroke(stroke, this.#canvas)) }
        added.push(own)
        return own
      }
      last = index
      removed.delete(this.#strokes[index])
      return this.#strokes[index]
    })
    return { placed, changed: [...removed, ...added] }
  }

  get #whole(): Bounds {
    const { width, height } = this.#drawn.heights
    return { x0: 0, y0: 0, x1: width, y1: height }
  }

  #drawNormals(bounds: Bounds): void {
    drawNormals(this.normal, bounds, this.heights, this.#canvas.metric, this.#frame)
    if (this.#base) overlayNormals(this.#base, this.normal, bounds)
  }
}

/** Data for repeated edits of one stroke. */
interface Edit {
  /** Strokes before the edited one in the list. */
  before: readonly PlacedStroke[]
  /** Strokes after the edited one in the list. */
  after: readonly PlacedStroke[]
  others: OtherStrokes
}

/** Returns whether a list of strokes consists of `before`, at most one stroke, and `after`. */
function matchesEdit(strokes: readonly PlacedStroke[], { before, after }: Edit): boolean {
  const more = strokes.length - before.length - after.length
  return (
    (more === 0 || more === 1) &&
    before.every((each, i) => each === strokes[i]) &&
    after.every((each, i) => each === strokes[before.length + more + i])
  )
}

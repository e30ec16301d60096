import type { Bounds } from '../../core/bounds.ts'
import type { GrayImage } from '../../core/types.ts'
import type { SkinCanvas } from '../skin/canvas.ts'
import { ChangedTexels } from './changed-texels.ts'
import { isBulge } from './lay-out.ts'
import { deepestByGroup, OnsetPen, onsetLines } from './onset.ts'
import { gridOf, overlap, type PlacedStroke } from './placed-stroke.ts'

/** Onset map of strokes that is redrawn where strokes change. The result is bit-identical to `strokesToOnset`. */
export class OnsetLayer {
  /** `draw` changes this map in place. */
  readonly map: GrayImage
  readonly #texels: SkinCanvas['texels']
  /** Depth of the deepest point of each group, millimetres. */
  #deepest = new Map<string | undefined, number>()

  constructor({ texels }: Pick<SkinCanvas, 'texels'>) {
    const { width, height } = texels
    this.map = { width, height, data: new Uint8Array(width * height) }
    this.#texels = texels
  }

  /**
   * Updates the map to a new list of strokes.
   *
   * @param all strokes of the layer. Bulges have no onset.
   * @param changed strokes that were added or removed.
   * @returns changed rectangles in texels.
   */
  draw(all: readonly PlacedStroke[], changed: readonly PlacedStroke[]): Bounds[] {
    const strokes = all.filter(isValley)
    const before = this.#deepest
    const deepest = deepestByGroup(strokes.map(({ stroke, laid }) => ({ group: stroke.group, lines: laid })))
    this.#deepest = deepest
    // Depths are relative to the deepest point of the group, so its change affects the whole group.
    const isOther = ({ stroke: { group } }: PlacedStroke) => before.get(group) !== deepest.get(group)
    const redrawn = [...new Set([...changed.filter(isValley), ...strokes.filter(isOther)])]
    if (redrawn.length === 0) return []
    const near = strokes.filter(({ box }) => redrawn.some((other) => overlap(box, other.box)))
    const lines = near.flatMap(({ stroke, laid }) => onsetLines(laid, deepest.get(stroke.group) ?? 0))
    const pen = new OnsetPen(lines, this.map)
    const touched = gridOf(redrawn)
    const texels = new ChangedTexels(this.map.width, this.map.height)
    this.#texels.visitNear(touched.isNear, (texel, position, normal) => {
      if (pen.begins(texel) && touched.isWithinReach(position) && pen.draw(texel, position, normal))
        texels.add(texel)
    })
    // A block is wider than the texel that it was drawn at.
    return texels.around(1)
  }
}

function isValley({ stroke }: PlacedStroke): boolean {
  return !isBulge(stroke)
}

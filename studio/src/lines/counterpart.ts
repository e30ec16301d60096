import { mirrorStroke } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import { splitSide } from '../document/sides.ts'
import type { LineSurface } from './line-surface.ts'

/** Maximum mean distance between the mirror image of a line and its counterpart, millimetres. Automatic lines are not quite symmetric. */
const MAX_APART = 8

/** Finds counterparts of lines, and remembers them during a gesture. */
export class Counterparts {
  /** The keys and values are indices of lines. */
  readonly #known = new Map<number, number>()

  forget(): void {
    this.#known.clear()
  }

  /** Returns the index of a line's counterpart, or -1. @param index index of the line in `strokes`. */
  of(index: number, strokes: readonly LayerStroke[], surface: LineSurface): number {
    const known = this.#known.get(index)
    if (known !== undefined) return known
    const found = counterpartOf(strokes, index, surface)
    this.#known.set(index, found)
    return found
  }

  /**
   * Adds the counterparts of changed lines, unless they are changed lines themselves.
   *
   * @param strokes strokes before the change.
   * @param change returns the changed counterpart. Default: the mirror image of the changed line.
   */
  add(
    changed: ReadonlyMap<number, LayerStroke>,
    strokes: readonly LayerStroke[],
    surface: LineSurface,
    change: (other: LayerStroke, stroke: LayerStroke, index: number) => LayerStroke = (other, stroke) =>
      mirrorOnto(stroke, other, surface),
  ): ReadonlyMap<number, LayerStroke> {
    const all = new Map(changed)
    for (const [index, stroke] of changed) {
      const other = this.of(index, strokes, surface)
      if (other >= 0 && !changed.has(other)) all.set(other, change(strokes[other], stroke, index))
    }
    return all
  }
}

/** Returns the mirror image of `stroke`, in the layer and the group of `other`. The image can replace `other`. */
export function mirrorOnto(stroke: LayerStroke, other: LayerStroke, surface: LineSurface): LayerStroke {
  const { group, ...mirrored } = mirrorStroke(stroke, surface.canvas, surface.middle)
  return { ...mirrored, layer: other.layer, ...(other.group !== undefined && { group: other.group }) }
}

/**
 * Finds a line's counterpart on the other half of the face. Among the lines of the same layer and the same region on either side, the counterpart
 * is the nearest to the line's mirror image. Returns -1 if no line is near enough. Also returns -1 if the line itself is the nearest, because it
 * crosses the middle of the face.
 *
 * @param index index of the line in `strokes`.
 */
export function counterpartOf(strokes: readonly LayerStroke[], index: number, surface: LineSurface): number {
  const stroke = strokes[index]
  const image = pointsOf(mirrorStroke(stroke, surface.canvas, surface.middle), surface)
  let [nearest, least] = [-1, MAX_APART]
  for (const [i, other] of strokes.entries()) {
    if (other.layer !== stroke.layer || stemOf(other) !== stemOf(stroke)) continue
    const distance = meanDistance(image, pointsOf(other, surface))
    if (distance < least) [nearest, least] = [i, distance]
  }
  return nearest === index ? -1 : nearest
}

function stemOf({ group = '' }: LayerStroke): string {
  return splitSide(group)[0]
}

/** Returns the packed positions of a line's points, millimetres. */
function pointsOf(stroke: LayerStroke, { lines }: LineSurface): Float64Array {
  return Float64Array.from(lines.lineOf(stroke)?.points ?? [])
}

/** Returns the mean distance from each point of `a` to the nearest point of `b`, averaged with the reverse. */
function meanDistance(a: Float64Array, b: Float64Array): number {
  return (meanToNearest(a, b) + meanToNearest(b, a)) / 2
}

function meanToNearest(from: Float64Array, to: Float64Array): number {
  let sum = 0
  for (let i = 0; i < from.length; i += 3) {
    let least = Number.POSITIVE_INFINITY
    for (let k = 0; k < to.length; k += 3)
      least = Math.min(
        least,
        (from[i] - to[k]) ** 2 + (from[i + 1] - to[k + 1]) ** 2 + (from[i + 2] - to[k + 2]) ** 2,
      )
    sum += Math.sqrt(least)
  }
  return from.length > 0 ? sum / (from.length / 3) : Number.POSITIVE_INFINITY
}

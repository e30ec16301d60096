import { mirrorStroke } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import { splitSide } from '../document/sides.ts'
import type { LineSurface } from './line-surface.ts'

/** Maximum mean distance between the mirror image of a line and its counterpart, millimetres. Automatic lines are not quite symmetric. */
const MAX_APART = 8

/** Returns a stroke on the other half of the face, in the same layer and with the group of `other`. */
export function mirrorOnto(stroke: LayerStroke, other: LayerStroke, surface: LineSurface): LayerStroke {
  const { group, ...mirrored } = mirrorStroke(stroke, surface.canvas, surface.middle)
  return { ...mirrored, layer: other.layer, ...(other.group !== undefined && { group: other.group }) }
}

/**
 * Finds the line on the other half of the face that corresponds to a line: the nearest line to its mirror image among the lines of the same
 * region. Returns -1 if there is none, or if the line crosses the middle of the face and so is its own counterpart.
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

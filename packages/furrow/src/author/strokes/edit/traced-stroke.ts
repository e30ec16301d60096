import type { Uv } from '../../../core/json.ts'
import { barycentricsAt, positionAt } from '../../skin/walk.ts'
import { type LocatedSkin, layCurve } from '../curve.ts'
import type { Stroke } from '../document.ts'
import { arcLengths } from '../lay-out.ts'

/** Line of a stroke (a wrinkle) on the skin, from end to end in short steps. One long step crosses each gap in the skin. */
export interface TracedStroke {
  /** Packed xyz in millimetres. */
  points: Float64Array
  /** Triangle of the skin at each point. */
  triangles: readonly number[]
  /** Arc length in millimetres from the start to each point. */
  lengths: Float64Array
}

/** Converts a stroke to a line on the skin. The line has no points if the stroke is outside the skin. */
export function traceStroke(stroke: Stroke, skin: LocatedSkin): TracedStroke {
  const lines = layCurve(stroke, skin)
  const points = Float64Array.from(lines.flatMap((line) => [...line.points]))
  return {
    points,
    triangles: lines.flatMap(({ triangles }) => triangles),
    lengths: points.length > 0 ? arcLengths({ points }) : new Float64Array(0),
  }
}

export function uvOf({ points, triangles }: TracedStroke, i: number, { surface, locator }: LocatedSkin): Uv {
  const weights = new Float64Array(3)
  barycentricsAt(weights, surface, triangles[i], points.subarray(3 * i, 3 * i + 3))
  return clamped(locator.uvAt(triangles[i], weights))
}

/** Clamps UV coordinates to 0..1, the range allowed in documents. A line that passes the skin's border can exceed this range. */
export function clamped([u, v]: Uv): Uv {
  return [Math.min(1, Math.max(0, u)), Math.min(1, Math.max(0, v))]
}

/** Returns the index of the line's point at each control point of a spline. A control point outside the skin gets the previous one's index. */
export function knotsOf(
  { points: uvs }: Stroke,
  line: TracedStroke,
  { surface, locator }: LocatedSkin,
): number[] {
  const [position, weights] = [new Float64Array(3), new Float64Array(3)]
  const { points } = line
  let from = 0
  return uvs.map(([u, v]) => {
    const triangle = locator.find(u, v, weights)
    if (triangle < 0) return from
    positionAt(position, surface, triangle, weights)
    for (let i = from; i < line.triangles.length; i++) {
      const isHere =
        points[3 * i] === position[0] &&
        points[3 * i + 1] === position[1] &&
        points[3 * i + 2] === position[2]
      if (!isHere) continue
      from = i
      break
    }
    return from
  })
}

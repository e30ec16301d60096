import { length3 } from '../../../math/vector.ts'
import type { SkinCanvas } from '../../skin/canvas.ts'
import type { Stroke } from '../document.ts'
import { layOutStroke } from '../lay-out.ts'

/** A part of a stroke as a line in space, in the coordinates of the mesh. */
export interface StrokeCurve {
  /** x, y and z of each point. */
  points: Float64Array
  /** The skin's unit normals there. */
  normals: Float64Array
  /** How far along the stroke each point is, as a fraction of its length, 0..1. */
  along: Float64Array
}

/** The point of a stroke that is nearest to a position. */
export interface StrokePoint {
  position: [x: number, y: number, z: number]
  /** From the position, in the unit of the mesh. */
  distance: number
  /** How far along the stroke it is, as a fraction of its length, 0..1. */
  along: number
}

/**
 * The bottom of a stroke's valley as lines on the face, at most half a millimetre from point to point: to be drawn, and to be picked.
 *
 * @returns one part, or several where the stroke is interrupted; none where none of it is on the skin.
 */
export function strokeCurves(stroke: Stroke, canvas: SkinCanvas): StrokeCurve[] {
  return layOutStroke(stroke, canvas).map(({ points, normals, span: [start, end] }) => {
    const last = points.length / 3 - 1
    return {
      points: points.map((value) => value / canvas.scale),
      normals,
      along: Float64Array.from({ length: last + 1 }, (_, i) => start + (i / last) * (end - start)),
    }
  })
}

/**
 * Finds the point of a stroke that is nearest to a position in the coordinates of the mesh.
 *
 * @returns undefined where the stroke has no parts.
 */
export function nearestOnStroke(
  curves: readonly StrokeCurve[],
  position: readonly [x: number, y: number, z: number],
): StrokePoint | undefined {
  let nearest: StrokePoint | undefined
  for (const { points, along } of curves) {
    for (let i = 0; i + 1 < along.length; i++) {
      const start = points.subarray(3 * i, 3 * i + 3)
      const step = start.map((value, k) => points[3 * i + 3 + k] - value)
      const [square, along_] = start.reduce(
        ([square, sum], value, k) => [square + step[k] ** 2, sum + step[k] * (position[k] - value)],
        [0, 0],
      )
      const t = Math.min(1, Math.max(0, along_ / (square || 1)))
      const [x, y, z] = start.map((value, k) => value + t * step[k])
      const distance = length3(x - position[0], y - position[1], z - position[2])
      if (nearest && distance >= nearest.distance) continue
      nearest = { position: [x, y, z], distance, along: along[i] + t * (along[i + 1] - along[i]) }
    }
  }
  return nearest
}

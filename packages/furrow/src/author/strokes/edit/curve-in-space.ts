import { length3 } from '../../../math/vector.ts'
import type { SkinCanvas } from '../../skin/canvas.ts'
import type { Stroke } from '../document.ts'
import { layOutStroke } from '../lay-out.ts'

/** Uninterrupted part of a stroke (a wrinkle) as a 3D line in mesh coordinates. */
export interface StrokeCurve {
  /** Packed xyz. */
  points: Float64Array
  /** Unit normals of the skin at the points, packed xyz. */
  normals: Float64Array
  /** Position of each point along the stroke, as a fraction of the stroke's length, 0..1. */
  along: Float64Array
}

/** Point on a stroke's line. It is the point nearest to a given position. */
export interface StrokePoint {
  position: [x: number, y: number, z: number]
  /** Distance from the given position, in mesh units. */
  distance: number
  /** Position along the stroke, as a fraction of the stroke's length, 0..1. */
  along: number
}

/**
 * Returns the centre line of a stroke's valley on the face, for drawing and picking. The points are at most half a millimetre apart.
 *
 * @returns several parts if the stroke is interrupted, none if it is outside the skin.
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
 * Finds the point of a stroke nearest to a position in mesh coordinates.
 *
 * @returns undefined if the stroke has no parts.
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
      const [square, projection] = start.reduce(
        ([square, sum], value, k) => [square + step[k] ** 2, sum + step[k] * (position[k] - value)],
        [0, 0],
      )
      const t = Math.min(1, Math.max(0, projection / (square || 1)))
      const [x, y, z] = start.map((value, k) => value + t * step[k])
      const distance = length3(x - position[0], y - position[1], z - position[2])
      if (nearest && distance >= nearest.distance) continue
      nearest = { position: [x, y, z], distance, along: along[i] + t * (along[i + 1] - along[i]) }
    }
  }
  return nearest
}

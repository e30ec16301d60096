import type { SkinCanvas } from '../../skin/canvas.ts'
import { nearestOnSurface } from '../../skin/nearest.ts'
import { positionAt } from '../../skin/walk.ts'
import type { Stroke } from '../document.ts'
import { splineOf } from './spline-of.ts'
import { clamped } from './traced-stroke.ts'

/** Symmetry plane of a face, in mesh coordinates. */
export interface MirrorPlane {
  /** Position in the plane. */
  origin: readonly [x: number, y: number, z: number]
  /** Unit normal of the plane. */
  normal: readonly [x: number, y: number, z: number]
}

/** x = 0, the symmetry plane of most character models. */
const MIDDLE: MirrorPlane = { origin: [0, 0, 0], normal: [1, 0, 0] }

/**
 * Mirrors a stroke across a plane: each point goes to the point of the skin nearest to its mirror image. Left and right of the
 * cross-section are swapped, and the group's suffix `Left` or `Right`. If both halves share texels, a stroke is its own mirror image.
 *
 * @param plane default: x = 0; `middleOf` finds a face's plane.
 * @returns the mirrored stroke as a spline (`splineOf`).
 */
export function mirrorStroke<S extends Stroke>(stroke: S, canvas: SkinCanvas, plane = MIDDLE): S {
  const { surface, locator, scale } = canvas
  const spline = splineOf(stroke, canvas)
  const [position, weights] = [new Float64Array(3), new Float64Array(3)]
  const points = spline.points.flatMap(([u, v]) => {
    const triangle = locator.find(u, v, weights)
    if (triangle < 0) return []
    positionAt(position, surface, triangle, weights)
    const rise = plane.normal.reduce((sum, n, k) => sum + n * (position[k] - scale * plane.origin[k]), 0)
    for (let k = 0; k < 3; k++) position[k] -= 2 * rise * plane.normal[k]
    return [clamped(locator.uvAt(nearestOnSurface(surface, position, weights), weights))]
  })
  const swapped = ([left, right]: Stroke['shoulder']): Stroke['shoulder'] => [right, left]
  const mirrored: S = {
    ...spline,
    shoulder: swapped(spline.shoulder),
    points: points.length < 2 ? spline.points : points,
  }
  if (spline.bank) mirrored.bank = swapped(spline.bank)
  if (spline.lean !== undefined) mirrored.lean = -spline.lean
  if (spline.group !== undefined)
    mirrored.group = spline.group.replace(/(Left|Right)$/, (side) => (side === 'Left' ? 'Right' : 'Left'))
  return mirrored
}

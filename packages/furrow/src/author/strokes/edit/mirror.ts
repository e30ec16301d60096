import { mirroredName } from '../../../drivers/morph/mirrored-name.ts'
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
 * Mirrors a stroke (a wrinkle) across a plane. Each control point moves to the point of the skin nearest to its mirror image. The left and
 * right values of the cross-section are swapped, and so are the suffixes `Left` and `Right` of the group's name. If both halves of the face
 * share texels, the mirrored stroke has the same points as the original.
 *
 * @param plane symmetry plane of the face. Default: x = 0.
 * @returns the mirrored stroke, converted to a spline by `splineOf`.
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
  if (spline.group !== undefined) mirrored.group = mirroredName(spline.group)
  return mirrored
}

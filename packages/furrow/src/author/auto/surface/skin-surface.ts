import { pointAreas, pointOffsets, type Skin, type SkinSurface, weldSurface } from '../../skin/surface.ts'
import { type DetectedFace, placedFace } from './detect-face.ts'

/**
 * Converts a skin to the surface in millimetres that `autoWrinkles` uses. Vertices with equal positions are merged.
 *
 * @returns the surface, and the number of millimetres per unit of the skin. The surface of a face is in face coordinates: the origin is the
 *   midpoint of the eyes, x points to the person's left, y up and z forwards. Other skins keep their coordinate axes.
 */
export function skinSurface(skin: Skin): { surface: SkinSurface; scale: number } {
  const { surface, scale } = placedFace(skin) ?? weldInMillimetres(skin)
  return { surface, scale }
}

/** Maximum area in square millimetres: almost twice that of a tall adult (2.2 square metres, Mosteller 1987). Larger models are not in metres. */
const MAX_AREA = 4e6

/** Converts a skin that is not a face to a surface in millimetres. The skin is assumed to be in metres, unless its area exceeds `MAX_AREA`. */
export function weldInMillimetres(
  skin: Skin,
): Pick<DetectedFace, 'surface' | 'offsets' | 'scale' | 'toSurface'> {
  const welded = weldSurface(skin)
  const sum = pointAreas(welded.points, welded.corners).reduce((sum, area) => sum + area, 0)
  let scale = 1000
  // Models in centimetres, millimetres or other units are scaled down until they are at most as large as a person.
  while (scale ** 2 * sum > MAX_AREA && scale > Number.MIN_VALUE) scale /= 10
  const points = welded.points.map((value) => scale * value)
  const surface = { ...welded, points, areas: pointAreas(points, welded.corners) }
  return {
    surface,
    scale,
    toSurface: [scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1],
    offsets: skin.targets.map((target) => pointOffsets(welded, target).map((value) => scale * value)),
  }
}

import { pointAreas, pointOffsets, type Skin, type SkinSurface, weldSurface } from '../../skin/surface.ts'
import { type DetectedFace, placedFace } from './detect-face.ts'

/**
 * Welds a skin into one surface in millimetres, as `autoWrinkles` measures it.
 *
 * @returns the surface, and millimetres per unit of the skin. Faces are in face coordinates: x to the person's left, y up, z forwards,
 *   from the midpoint of the eyes. Other skins keep their coordinates.
 */
export function skinSurface(skin: Skin): { surface: SkinSurface; scale: number } {
  const { surface, scale } = placedFace(skin) ?? weldInMillimetres(skin)
  return { surface, scale }
}

/** Maximum area in square millimetres: a tall adult's skin has 2.2 square metres (Mosteller 1987). Larger models use another unit. */
const MAX_AREA = 4e6

/** Welds a skin that is not a face, in metres as in glTF, into one surface in millimetres. */
export function weldInMillimetres(skin: Skin): Pick<DetectedFace, 'surface' | 'offsets' | 'scale'> {
  const welded = weldSurface(skin)
  const sum = pointAreas(welded.points, welded.corners).reduce((sum, area) => sum + area, 0)
  let scale = 1000
  // Centimetres, millimetres or other units: reduce to at most the size of a person.
  while (scale ** 2 * sum > MAX_AREA && scale > Number.MIN_VALUE) scale /= 10
  const points = welded.points.map((value) => scale * value)
  const surface = { ...welded, points, areas: pointAreas(points, welded.corners) }
  return {
    surface,
    scale,
    offsets: skin.targets.map((target) => pointOffsets(welded, target).map((value) => scale * value)),
  }
}

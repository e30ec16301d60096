import { pointAreas, pointOffsets, type Skin, type SkinSurface, weldSurface } from '../../skin/surface.ts'
import { type DetectedFace, placedFace } from './detect-face.ts'

/**
 * A skin as one welded surface in millimetres, as `autoWrinkles` measures it.
 *
 * @returns of a face in its own frame: x to the person's left, y up, z forwards, from the midpoint between the eyes. Of anything else in the
 *   frame of its positions. With the millimetres per unit of the skin.
 */
export function skinSurface(skin: Skin): { surface: SkinSurface; scale: number } {
  const { surface, scale } = placedFace(skin) ?? weldInMillimetres(skin)
  return { surface, scale }
}

/** The skin of a tall adult has 2.2 square metres (Mosteller 1987); more is a model in another unit. */
const MAX_AREA = 4e6

/** A skin that is not a face, in metres as glTF has it, as one surface in millimetres. */
export function weldInMillimetres(skin: Skin): Pick<DetectedFace, 'surface' | 'offsets' | 'scale'> {
  const welded = weldSurface(skin)
  const sum = pointAreas(welded.points, welded.corners).reduce((sum, area) => sum + area, 0)
  let scale = 1000
  // Centimetres, millimetres, or anything else: what is left is the size of a person at most.
  while (scale ** 2 * sum > MAX_AREA && scale > Number.MIN_VALUE) scale /= 10
  const points = welded.points.map((value) => scale * value)
  const surface = { ...welded, points, areas: pointAreas(points, welded.corners) }
  return {
    surface,
    scale,
    offsets: skin.targets.map((target) => pointOffsets(welded, target).map((value) => scale * value)),
  }
}

import { joinSurface, pointAreas, pointOffsets, type Skin, type Surface } from './surface.ts'

/** A skin that is no face as one surface, from metres as glTF has it, and what its targets add to the points. */
export function inMillimetres(skin: Skin): { surface: Surface; offsets: Float64Array[] } {
  const joined = joinSurface(skin)
  const points = joined.points.map((metres) => 1000 * metres)
  const surface = { ...joined, points, areas: pointAreas(points, joined.corners) }
  return {
    surface,
    offsets: skin.targets.map((target) => pointOffsets(joined, target).map((metres) => 1000 * metres)),
  }
}

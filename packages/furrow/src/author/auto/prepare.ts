import { checkSkin } from './check-skin.ts'
import { type Face, findFace } from './face.ts'
import { joinSurface, pointAreas, pointOffsets, type Skin, type Surface } from './surface.ts'
import { inFirstTile } from './tiles.ts'

/** A skin that can be worked on. */
export interface PreparedSkin {
  /** Without broken targets, in the first tile of its texture. */
  skin: Skin
  /** If its targets show that it is one. */
  face: Face | undefined
  /** In millimetres, and what each target adds to its points. */
  surface: Surface
  offsets: readonly Float64Array[]
  /** What the user should know, a sentence each. */
  warnings: string[]
}

/**
 * Checks a skin, moves it to where renderers look in its texture, and recognises a face.
 *
 * @throws FurrowError for what no wrinkles can be made from.
 */
export function prepareSkin(raw: Skin): PreparedSkin {
  const { skin: checked, warnings } = checkSkin(raw)
  const { skin, crossing } = inFirstTile(checked)
  if (crossing > 0) {
    const share = Math.max(1, Math.round(100 * crossing))
    warnings.push(`${share}% of the skin crosses the edges of its texture: nothing is drawn beyond them`)
  }
  const face = findFace(skin)
  const { surface, offsets } = face ?? inMillimetres(skin)
  return { skin, face, surface, offsets, warnings }
}

/** A skin that is no face as one surface, from metres as glTF has it, and what its targets add to the points. */
function inMillimetres(skin: Skin): { surface: Surface; offsets: Float64Array[] } {
  const joined = joinSurface(skin)
  const points = joined.points.map((metres) => 1000 * metres)
  const surface = { ...joined, points, areas: pointAreas(points, joined.corners) }
  return {
    surface,
    offsets: skin.targets.map((target) => pointOffsets(joined, target).map((metres) => 1000 * metres)),
  }
}

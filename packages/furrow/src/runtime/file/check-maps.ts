import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { mapProblems, type TextureShape, texturesOfFace } from '../../core/maps/rules.ts'
import type { MapsAndAreas } from '../../core/maps/wrinkle-maps.ts'

/**
 * Checks the maps of a file against each other, and against its own maps. Fetched: most files have images of one size for each kind.
 *
 * @param shapes of all textures that are drawn.
 * @throws FurrowError when the maps break a rule.
 */
export function checkMaps(
  maps: MapsAndAreas,
  shapes: ReadonlyMap<number, TextureShape>,
  json: Parameters<typeof texturesOfFace>[0],
): void {
  const [problem] = mapProblems(maps, (texture) => shapes.get(texture)!, texturesOfFace(json), WRINKLE_MAPS)
  if (problem) throw new FurrowError(problem)
}

import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { mapProblems, type TextureShape, texturesOfFace } from '../../core/maps/rules.ts'
import type { MapsAndAreas } from '../../core/maps/wrinkle-maps.ts'

/** The images and arrays of a file that were read, by their textures. */
interface ReadMaps {
  images: ReadonlyMap<number, Promise<TextureShape>>
  arrays: ReadonlyMap<number, Promise<{ header: TextureShape }>>
}

/**
 * Checks the maps of a file against each other, and against its own maps. Fetched: most files have images of one size for each kind.
 *
 * @param read all textures that are drawn.
 * @throws FurrowError when the maps break a rule.
 */
export async function checkMaps(
  maps: MapsAndAreas,
  read: ReadMaps,
  json: Parameters<typeof texturesOfFace>[0],
): Promise<void> {
  const shapes = new Map<number, TextureShape>()
  for (const [texture, image] of read.images) shapes.set(texture, await image)
  for (const [texture, array] of read.arrays) shapes.set(texture, (await array).header)
  const [problem] = mapProblems(maps, (texture) => shapes.get(texture)!, texturesOfFace(json), WRINKLE_MAPS)
  if (problem) throw new FurrowError(problem)
}

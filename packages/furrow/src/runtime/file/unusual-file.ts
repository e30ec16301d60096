import type { FurrowError } from '../../core/error.ts'
import { checkDeclared, WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { parseWrinkleMaps, type WrinkleMaps } from '../../drivers/parse.ts'
import type { WrinkledFile } from './wrinkled-file.ts'

/** Files with such images are out of the usual too. */
export { ArraySource } from './array-source.ts'

/**
 * Reads the extension's JSON of a material, whatever is in it.
 *
 * @param file JSON of the whole file.
 * @param onFault is told of each malformed driver, which is then left out; by default it is thrown.
 * @throws FurrowError that says what is wrong with it, or that the file does not declare the extension.
 */
export function parseMaps(
  json: unknown,
  file: WrinkledFile['json'],
  onFault?: (fault: FurrowError) => void,
): WrinkleMaps {
  const { textures } = file
  const maps = parseWrinkleMaps(json, Array.isArray(textures) ? textures.length : 0, WRINKLE_MAPS, onFault)
  checkDeclared(file, WRINKLE_MAPS)
  return maps
}

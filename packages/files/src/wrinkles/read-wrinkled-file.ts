import type { ReadOptions } from '../disk/external-files.ts'
import { readGlbFile } from '../gltf/read-glb-file.ts'
import { type WrinkledFile, wrinkledFile } from './wrinkled-file.ts'

/**
 * Reads a glTF file and the wrinkles of one of its materials.
 *
 * @param options.material name of the material. Default: the only material with wrinkles.
 * @throws FurrowError like `readGlbFile` and `wrinkledFile`.
 */
export async function readWrinkledFile(
  path: string,
  who: string,
  options: ReadOptions & { material?: string | undefined } = {},
): Promise<WrinkledFile> {
  return wrinkledFile(await readGlbFile(path, who, options), path, who, options.material)
}

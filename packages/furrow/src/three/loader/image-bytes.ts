import { LoaderUtils } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { notFetched } from '../../runtime/file/image-faults.ts'

/**
 * Reads the bytes of an image of a file, in the file or beside it.
 *
 * @param image its index.
 * @param who names the texture in errors.
 * @returns undefined where there is no such image.
 * @throws FurrowError when it cannot be fetched.
 */
export async function readImageBytes(
  parser: GLTFParser,
  image: unknown,
  who: string,
): Promise<Uint8Array<ArrayBuffer> | undefined> {
  const { bufferView, uri } = parser.json.images?.[image as number] ?? {}
  if (bufferView !== undefined) return new Uint8Array(await parser.getDependency('bufferView', bufferView))
  if (typeof uri !== 'string') return undefined
  const address = LoaderUtils.resolveURL(uri, parser.options.path)
  try {
    return new Uint8Array((await parser.fileLoader.loadAsync(address)) as ArrayBuffer)
  } catch {
    throw notFetched(address, who)
  }
}

import { LoaderUtils } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { notFetched } from '../../runtime/file/image-errors.ts'

/**
 * Reads the bytes of a glTF image, which may be embedded or in a separate file.
 *
 * @param image image index.
 * @param who name of the texture, for errors.
 * @returns the bytes, or undefined if there is no image with this index.
 * @throws FurrowError if the image cannot be fetched.
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

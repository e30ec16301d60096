import { FurrowError } from 'furrow'
import { imageTypeOf, type Ktx2Header, readKtx2Header } from 'furrow/internal'
import type { Glb } from './glb.ts'

export interface TextureImage {
  bytes: Uint8Array
  /**
   * MIME type, recognised by the first bytes of the image. If they are unknown, the type that the file declares, or
   * `unknown`.
   */
  mimeType: string
  name: string
}

/** Extensions that add an image in another format to a texture. */
const IMAGE_EXTENSIONS = ['KHR_texture_basisu', 'EXT_texture_webp', 'EXT_texture_avif']

/** Returns the encoded image of a texture. Throws if the file does not contain the image. */
export function imageOf({ json, bin }: Glb, texture: number, who: string): TextureImage {
  const { source, extensions = {}, name } = json.textures?.[texture] ?? {}
  const other = IMAGE_EXTENSIONS.map((key) => (extensions[key] as { source?: number } | undefined)?.source)
  const image = json.images?.[other.find((index) => index !== undefined) ?? source ?? -1]
  const view = json.bufferViews?.[image?.bufferView ?? -1]
  const start = view?.byteOffset ?? 0
  if (
    !image ||
    !view ||
    view.buffer !== 0 ||
    start + view.byteLength > bin.length ||
    !(view.byteLength > 0)
  ) {
    throw new FurrowError({
      who,
      problem: `texture ${texture} has no image in the file`,
      value: image?.uri,
      remedy: 'export the file as one .glb with its images inside',
    })
  }
  const bytes = bin.subarray(start, start + view.byteLength)
  return {
    bytes,
    mimeType: imageTypeOf(bytes) ?? image.mimeType ?? 'unknown',
    name: image.name ?? name ?? `texture ${texture}`,
  }
}

export function isKtx2({ mimeType }: TextureImage): boolean {
  return mimeType === 'image/ktx2'
}

/**
 * Reads the KTX 2 header of a texture with KHR_texture_basisu. Returns undefined for other textures.
 *
 * @throws FurrowError if the image is not KTX 2, or violates the extension.
 */
export function ktx2HeaderOf(glb: Glb, texture: number, who: string): Ktx2Header | undefined {
  if (!glb.json.textures?.[texture]?.extensions?.KHR_texture_basisu) return undefined
  return readKtx2Header(imageOf(glb, texture, who).bytes, `${who}: texture ${texture}`)
}

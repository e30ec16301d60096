import { FurrowError } from 'furrow'
import { imageTypeOf, type Ktx2Header, readKtx2Header } from 'furrow/internal'
import type { Glb } from './glb.ts'

/** The encoded image of a texture. */
export interface TextureImage {
  bytes: Uint8Array
  /** By its first bytes; where these do not tell, as the file says, or `unknown`. */
  mimeType: string
  name: string
}

/** Extensions that give a texture an image in another format. */
const IMAGE_EXTENSIONS = ['KHR_texture_basisu', 'EXT_texture_webp', 'EXT_texture_avif']

/** Finds the image of a texture. Throws FurrowError when there is none inside the file. */
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

/** Whether an image is a KTX 2 file. */
export function isKtx2({ mimeType }: TextureImage): boolean {
  return mimeType === 'image/ktx2'
}

/**
 * The header of the KTX 2 image of a texture, which only KHR_texture_basisu can give it; undefined for textures without.
 *
 * @throws FurrowError when it is not a KTX 2 image, or breaks the rules of that extension.
 */
export function ktx2HeaderOf(glb: Glb, texture: number, who: string): Ktx2Header | undefined {
  if (!glb.json.textures?.[texture]?.extensions?.KHR_texture_basisu) return undefined
  return readKtx2Header(imageOf(glb, texture, who).bytes, `${who}: texture ${texture}`)
}

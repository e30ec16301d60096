import { FurrowError } from 'furrow'
import type { Glb } from './glb-file.ts'

/** The encoded image of a texture. */
export interface TextureImage {
  bytes: Uint8Array
  /** As the file says; `unknown` where it does not. */
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
      what: `texture ${texture} has no image in the file`,
      value: image?.uri,
      remedy: 'export the file as one .glb with its images inside',
    })
  }
  return {
    bytes: bin.subarray(start, start + view.byteLength),
    mimeType: image.mimeType ?? 'unknown',
    name: image.name ?? name ?? `texture ${texture}`,
  }
}

/** Whether an image is a KTX 2 file. */
export function isKtx2({ mimeType }: TextureImage): boolean {
  return mimeType === 'image/ktx2'
}

/** Position of a word in the header of a KTX 2 file (KTX 2.0, 3.1). */
const LAYER_COUNT = 32

/** Layers of a KTX 2 array; 0 for an image of any other kind. */
export function layerCount(image: TextureImage): number {
  const { bytes } = image
  if (!isKtx2(image) || bytes.length < LAYER_COUNT + 4) return 0
  return Buffer.from(bytes.buffer, bytes.byteOffset, bytes.length).readUInt32LE(LAYER_COUNT)
}

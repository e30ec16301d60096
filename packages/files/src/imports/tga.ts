import { TGALoader } from 'three/addons/loaders/TGALoader.js'
import { checkImageSize } from '../images/check-image.ts'
import { withImageErrors } from '../images/image-errors.ts'
import type { Pixels } from '../images/pixels.ts'

/** Bytes of a TGA header up to the field that has the origin of the rows. */
const HEADER_BYTES = 18

/**
 * Decodes a Truevision TGA image to RGBA.
 *
 * @param name name of the image, for errors.
 * @throws FurrowError if the image is damaged, or larger than 8192 texels per side.
 */
export async function decodeTga(bytes: Uint8Array, name: string, who: string): Promise<Pixels> {
  return withImageErrors(name, who, async () => {
    if (bytes.length <= HEADER_BYTES) throw new Error('it has no TGA header')
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
    const [width, height] = [view.getUint16(12, true), view.getUint16(14, true)]
    checkImageSize({ width, height, decodedBytes: 4 * width * height }, name, who)
    const { data } = new TGALoader().parse(bytes.slice().buffer)
    return { width, height, channels: 4, data: Uint8Array.from(data as ArrayLike<number>) }
  })
}

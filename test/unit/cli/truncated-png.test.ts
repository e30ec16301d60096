import sharp from 'sharp'
import { expect, it } from 'vitest'
import { checkDecodable } from '../../../packages/files/src/images/codec.node.ts'

const [WIDTH, HEIGHT] = [61, 47]
const texels = Uint8Array.from({ length: WIDTH * HEIGHT * 3 }, (_, i) => (i * 7919 + (i >> 3) * 31) & 255)

const check = (bytes: Uint8Array) => checkDecodable(bytes, '"normal"', 'furrow unpack')

it.each([false, true])(
  'a PNG that is truncated at any byte is refused, interlaced: %s',
  async (progressive) => {
    const raw = { width: WIDTH, height: HEIGHT, channels: 3 } as const
    const png = await sharp(texels, { raw }).png({ progressive }).toBuffer()
    await check(png)
    // The pixel data ends before a checksum (4 bytes) and the chunk IEND.
    const end = png.lastIndexOf('IEND') - 8 - 4
    for (let length = 1; length < end; length += 97) {
      await expect(check(png.subarray(0, length)), `${length} bytes`).rejects.toThrow(/^furrow unpack: /)
    }
  },
)

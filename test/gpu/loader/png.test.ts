import { describe, expect, it } from 'vitest'
import { decodeBytes } from '../../../packages/furrow/src/runtime/file/decode-image.ts'
import { readImage } from '../../../packages/furrow/src/runtime/file/read-image.ts'
import { seeded } from '../../random.ts'
import { png } from '../images.ts'

/** Returns random pixels, with smooth rows among them, so that encoders use different row filters. */
function pixels(channels: number): Uint8Array {
  const random = seeded(channels)
  return Uint8Array.from({ length: 33 * 17 * channels }, (_, i) => (i % 3 === 0 ? random() * 256 : i % 256))
}

/** Decodes an image by the browser, without colour conversion, and reads it back through WebGL. */
async function byWebGL(file: Blob) {
  const options = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' } as const
  return readImage(await createImageBitmap(file, options))
}

const COLOURS = [
  ['gray', 0, 1],
  ['RGB', 2, 3],
  ['gray and alpha', 4, 2],
  ['RGBA', 6, 4],
] as const

describe('pixels of a PNG file', () => {
  it.each(COLOURS)('of %s are those that WebGL reads', async (_, colour, channels) => {
    for (const filter of [0, 1, 2, 3, 4]) {
      const file = await png(33, 17, 8, colour, pixels(channels), filter)
      const bytes = new Uint8Array(await file.arrayBuffer())
      const [own, expected] = [await decodeBytes(bytes, 'test'), await byWebGL(file)]
      expect([own.width, own.height]).toEqual([33, 17])
      expect(own.data.join(), `filter ${filter}`).toBe(expected.data.join())
    }
  })

  it.each(COLOURS)('of %s in 16 bits are the upper 8 bits in every browser', async (_, colour, channels) => {
    const values = pixels(2 * channels)
    const bytes = new Uint8Array(await (await png(33, 17, 16, colour, values)).arrayBuffer())
    const { data } = await decodeBytes(bytes, 'test')
    const upper = values.filter((_, i) => i % 2 === 0)
    const expected = Array.from({ length: 33 * 17 }, (_, i) => {
      const own = [...upper.subarray(i * channels, (i + 1) * channels)]
      const gray = channels < 3 ? [own[0], own[0], own[0], ...own.slice(1)] : own
      return gray.length === 3 ? [...gray, 255] : gray
    })
    expect([...data]).toEqual(expected.flat())
  })

  it('with alpha are refused if there are too few', async () => {
    const few = await png(33, 17, 8, 6, pixels(4).subarray(0, 33 * 16 * 4))
    await expect(decodeBytes(new Uint8Array(await few.arrayBuffer()), 'x.png')).rejects.toThrow(
      /^x.png: not a readable image, got "\d+ bytes"/,
    )
  })
})

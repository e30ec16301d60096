import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { encodePortablePng, type Pixels, withoutAlpha } from 'furrow-files'
import sharp, { type Sharp } from 'sharp'
import { describe, expect, it } from 'vitest'
import { decodeImage } from '../../../packages/files/src/images/codec.node.ts'
import { headerOf } from '../../../packages/files/src/images/header.ts'
import { isOpaque, toRgba } from '../../../packages/files/src/images/pixels.ts'
import { scaleImage } from '../../../packages/files/src/images/scale.ts'
import { seeded } from '../../random.ts'

const AREAS = fileURLToPath(new URL('../../../faces/human/areas/', import.meta.url))

function noise(width: number, height: number, channels: Pixels['channels'], seed = 1): Pixels {
  const next = seeded(seed)
  const data = Uint8Array.from({ length: width * height * channels }, () => Math.floor(256 * next()))
  return { width, height, channels, data }
}

const sharpOf = ({ data, ...raw }: Pixels) => sharp(data, { raw })

describe('an image header, read without a decoder', () => {
  const rgb = () => sharpOf(noise(37, 20, 3))
  it.each<[string, () => Sharp]>([
    [
      'a gray PNG',
      () =>
        sharpOf(noise(37, 20, 1))
          .toColourspace('b-w')
          .png(),
    ],
    ['a PNG of 16 bits', () => rgb().toColourspace('rgb16').png()],
    ['a PNG with a palette', () => rgb().png({ palette: true })],
    ['an RGBA PNG', () => sharpOf(noise(37, 20, 4)).png({ progressive: true })],
    ['a JPEG', () => rgb().jpeg()],
    ['a progressive JPEG', () => rgb().jpeg({ progressive: true })],
    ['a gray JPEG', () => rgb().toColourspace('b-w').jpeg()],
    [
      'a JPEG with a profile and EXIF',
      () =>
        rgb()
          .withIccProfile('p3')
          .withExif({ IFD0: { Artist: 'x' } })
          .jpeg(),
    ],
  ])('%s', async (_, make) => {
    const bytes = await make().toBuffer()
    const { width, height, channels, depth, format } = await sharp(bytes).metadata()
    const texelBytes = channels * (depth === 'ushort' ? 2 : 1)
    expect(headerOf(bytes, `image/${format}` as 'image/png')).toEqual({ width, height, texelBytes })
  })

  it('is undefined for a JPEG without a frame header, and for other formats', async () => {
    expect(headerOf(Uint8Array.of(0xff, 0xd8, 0xff, 0xd9), 'image/jpeg')).toBeUndefined()
    expect(headerOf(await rgb().webp().toBuffer(), 'image/webp')).toBeUndefined()
  })
})

describe('a portable PNG', () => {
  it.each([1, 2, 3, 4] as const)('of %d channels has the texels that it was made from', async (channels) => {
    const image = noise(19, 13, channels)
    const bytes = encodePortablePng(image)
    expect((await sharp(bytes).metadata()).channels).toBe(channels)
    expect([...toRgba(await decodeImage(bytes, 'x', 'test'))]).toEqual([...toRgba(image)])
  })

  it('of an area is hardly larger than one written by libvips', async () => {
    let [own, others] = [0, 0]
    for (const name of readdirSync(AREAS)) {
      const { data, info } = await sharp(readFileSync(AREAS + name))
        .toColourspace('b-w')
        .raw()
        .toBuffer({ resolveWithObject: true })
      const image: Pixels = { width: info.width, height: info.height, channels: 1, data }
      own += encodePortablePng(image).length
      others += (await sharpOf(image).toColourspace('b-w').png({ compressionLevel: 9 }).toBuffer()).length
    }
    expect(own / others).toBeLessThan(1.1)
  })
})

describe('scaling', () => {
  it.each([20, 100])('to %d texels gives nearly the result of libvips', async (size) => {
    // The image is smooth, because libvips computes with integers. On rough images its rounding errors are larger.
    const smooth = await sharpOf(noise(50, 40, 3))
      .blur(2)
      .raw()
      .toBuffer()
    const image: Pixels = { width: 50, height: 40, channels: 3, data: smooth }
    const theirs = await sharpOf(image)
      .resize(size, size, { fit: 'fill', kernel: 'mitchell' })
      .raw()
      .toBuffer()
    const own = scaleImage(image, size)
    expect(own).toMatchObject({ width: size, height: size, channels: 3 })
    const differences = own.data.map((value, i) => Math.abs(value - theirs[i]!))
    expect(Math.max(...differences)).toBeLessThanOrEqual(size < 50 ? 3 : 8)
  })

  it('keeps a flat image flat up to its edges, and clamps overshoot', () => {
    const flat = { ...noise(7, 9, 4), data: new Uint8Array(7 * 9 * 4).fill(200) }
    expect(new Set(scaleImage(flat, 5).data)).toEqual(new Set([200]))
    expect(new Set(scaleImage(flat, 23).data)).toEqual(new Set([200]))
    const step = { width: 2, height: 1, channels: 1 as const, data: Uint8Array.of(0, 255) }
    const [first, ...rest] = scaleImage(step, 16).data
    expect([first, rest.at(-1)]).toEqual([0, 255])
  })
})

it('alpha is detected, removed and added', () => {
  const rgba = noise(3, 2, 4)
  expect(isOpaque(rgba)).toBe(false)
  expect(isOpaque({ ...rgba, data: rgba.data.map((value, i) => (i % 4 === 3 ? 255 : value)) })).toBe(true)
  expect(isOpaque(noise(3, 2, 3))).toBe(true)
  expect([...withoutAlpha(rgba).data.subarray(3, 6)]).toEqual([...rgba.data.subarray(4, 7)])
  const gray = { width: 1, height: 1, channels: 2 as const, data: Uint8Array.of(7, 9) }
  expect([...toRgba(gray)]).toEqual([7, 7, 7, 9])
  expect(withoutAlpha(gray)).toMatchObject({ channels: 1, data: Uint8Array.of(7) })
})

import { packAreas, packColours, reference, resampleGray } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { randomImage } from '../../cases.ts'
import { seeded } from '../../random.ts'

const gray = (width: number, height: number, value: (x: number, y: number) => number) => ({
  width,
  height,
  data: Uint8Array.from({ length: width * height }, (_, i) => value(i % width, Math.floor(i / width))),
})

describe('packColours', () => {
  it("stores texel (x, y, layer d) at x + y * width + d * width * height, like the paper's arrays", () => {
    const random = seeded(1)
    const images = [randomImage(random, 5, 3), randomImage(random, 5, 3), randomImage(random, 5, 3)]
    const array = packColours(images)
    expect(array).toMatchObject({ width: 5, height: 3, depth: 3, channels: 4 })
    const [x, y, d] = [4, 1, 2]
    const offset = (x + y * 5 + d * 15) * 4
    expect([...array.data.subarray(offset, offset + 4)]).toEqual([
      ...images[2].data.subarray((x + y * 5) * 4, (x + y * 5) * 4 + 4),
    ])
  })

  it('refuses maps of unequal size, and names them', () => {
    const random = seeded(1)
    expect(() => packColours([randomImage(random, 4), randomImage(random, 4, 8)])).toThrow(
      'packColours: image 1 differs in size from image 0, got "4 x 8", allowed: 4 x 4; scale all images of the array to one size',
    )
  })

  it.each([
    [
      'too few bytes',
      { width: 4, height: 4, data: new Uint8Array(63) },
      /wrong length of RGBA image data, got "63 bytes", allowed: 64 bytes/,
    ],
    [
      'no width',
      { width: 0, height: 4, data: new Uint8Array(0) },
      /size out of range, got "0 x 4", allowed: 1 to 8192/,
    ],
    ['half a texel', { width: 1.5, height: 2, data: new Uint8Array(12) }, /size out of range/],
    [
      '16384 texels',
      { width: 16384, height: 1, data: new Uint8Array(65536) },
      /size out of range.*resize the image/,
    ],
  ])('refuses an image with %s', (_, image, message) => {
    expect(() => packColours([image])).toThrow(message)
  })

  it('refuses an empty list', () => expect(() => packColours([])).toThrow(/packColours: no images, got 0/))
})

describe('packAreas', () => {
  it('resamples areas of any size to one size, one channel each', () => {
    const array = packAreas([gray(7, 300, () => 255), gray(128, 128, () => 9), gray(2, 2, () => 40)])
    expect(array).toMatchObject({ width: 128, height: 128, depth: 3, channels: 1 })
    expect([array.data[0], array.data[128 * 128], array.data[2 * 128 * 128]]).toEqual([255, 9, 40])
  })

  it.each([0, 257])('refuses %i areas', (count) => {
    const areas = Array.from({ length: count }, () => gray(2, 2, () => 0))
    expect(() => packAreas(areas)).toThrow(
      new RegExp(`^packAreas: (no|too many) areas, got ${count}, allowed: 1 to 256`),
    )
  })

  it('accepts 256', () => {
    expect(
      packAreas(
        Array.from({ length: 256 }, (_, i) => gray(2, 2, () => i)),
        2,
      ).depth,
    ).toBe(256)
  })
})

describe('resampleGray', () => {
  it('preserves a constant and a ramp', () => {
    const ramp = resampleGray(
      gray(256, 256, (x) => x),
      64,
    )
    for (let x = 2; x < 62; x++) expect(Math.abs(ramp.data[x] - (4 * x + 1.5))).toBeLessThanOrEqual(0.51)
    expect(
      new Set(
        resampleGray(
          gray(3, 3, () => 77),
          50,
        ).data,
      ),
    ).toEqual(new Set([77]))
  })

  it('averages when downsampling: a fine checkerboard becomes gray', () => {
    const checker = resampleGray(
      gray(256, 256, (x, y) => ((x + y) % 2) * 255),
      32,
    )
    for (const value of checker.data) expect(Math.abs(value - 127.5)).toBeLessThanOrEqual(2)
  })

  it('upsamples bilinearly, with clamped edges', () => {
    const image = gray(4, 4, (x, y) => x * 50 + y * 20)
    const upsampled = resampleGray(image, 16)
    const array = { ...image, depth: 1, channels: 1 as const }
    for (let y = 0; y < 16; y++) {
      for (let x = 0; x < 16; x++) {
        const exact = reference.sampleArray(array, (x + 0.5) / 16, (y + 0.5) / 16, 0) * 255
        expect(Math.abs(upsampled.data[y * 16 + x] - exact)).toBeLessThanOrEqual(0.5)
      }
    }
  })
})

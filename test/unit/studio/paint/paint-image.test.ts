import { FurrowError, type GrayImage } from 'furrow'
import { describe, expect, it } from 'vitest'
import { paintImage } from '../../../../studio/src/paint/paint-image.ts'
import { empty } from './skins.ts'

/** Left half 255, right half 0. */
const half = (width: number, height: number): GrayImage => ({
  width,
  height,
  data: Uint8Array.from({ length: width * height }, (_, i) => (i % width < width / 2 ? 255 : 0)),
})

describe('an image painted on an area', () => {
  it.each([
    [64, 64],
    [256, 128],
    [16, 32],
  ])('of %d x %d texels is resampled to it', (width, height) => {
    const { image, dirty } = paintImage(empty(64), half(width, height), 'add')
    expect([image.width, image.height]).toEqual([64, 64])
    expect(image.data[32 * 64 + 20]).toBe(255)
    expect(image.data[32 * 64 + 50]).toBe(0)
    expect(dirty).toMatchObject({ x: 0, y: 0, height: 64 })
  })

  it('is added or removed up to its opacity, and the area it is painted on is left', () => {
    const before = empty(64, 100)
    const at = (mode: 'add' | 'remove') => paintImage(before, half(64, 64), mode, 0.5).image.data[0]
    expect([at('add'), at('remove')]).toEqual([Math.round(100 + 155 / 2), 50])
    expect(before.data[0]).toBe(100)
  })

  it('that changes nothing says so', () => {
    expect(paintImage(empty(64, 255), half(64, 64), 'add').dirty).toBeUndefined()
  })

  it('is refused with an opacity out of range', () => {
    for (const opacity of [-1, 2, Number.NaN])
      expect(() => paintImage(empty(64), half(64, 64), 'add', opacity)).toThrow(FurrowError)
  })
})

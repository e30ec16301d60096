import { imageDamage, imageTypeOf } from 'furrow/internal'
import sharp, { type Sharp } from 'sharp'
import { describe, expect, it } from 'vitest'

const image = sharp({ create: { width: 40, height: 30, channels: 3, background: '#8080ff' } })
const draw = (encode: (image: Sharp) => Sharp) => encode(image.clone()).toBuffer()

describe('the format of an image', () => {
  it.each<[string, (image: Sharp) => Sharp]>([
    ['image/png', (own) => own.png()],
    ['image/jpeg', (own) => own.jpeg()],
    ['image/webp', (own) => own.webp()],
    ['image/avif', (own) => own.avif()],
  ])('%s is known by its first bytes', async (type, encode) => {
    expect(imageTypeOf(await draw(encode))).toBe(type)
  })

  it('is unknown for empty or other bytes', () => {
    expect(imageTypeOf(new Uint8Array())).toBeUndefined()
    expect(imageTypeOf(new TextEncoder().encode('<svg xmlns="http://www.w3.org/2000/svg"/>'))).toBeUndefined()
  })
})

describe('a damaged image', () => {
  it.each<[string, (image: Sharp) => Sharp]>([
    ['PNG', (own) => own.png()],
    ['interlaced PNG', (own) => own.png({ progressive: true })],
    ['JPEG', (own) => own.jpeg()],
    ['progressive JPEG', (own) => own.jpeg({ progressive: true, quality: 100 })],
  ])('is detected wherever a %s is truncated, and not in a complete file', async (_, encode) => {
    const bytes = await draw(encode)
    expect(imageDamage(bytes)).toBeUndefined()
    expect(imageDamage(Buffer.concat([bytes, Buffer.from('a camera appends this')]))).toBeUndefined()
    for (let length = 12; length < bytes.length; length++) {
      expect(imageDamage(bytes.subarray(0, length)), `${length}`).toBe('truncated file')
    }
  })

  it('is detected by the checksums of a PNG, for any flipped bit', async () => {
    const bytes = await draw((own) => own.png())
    for (let bit = 8 * 8; bit < 8 * bytes.length; bit++) {
      const damaged = Buffer.from(bytes)
      damaged[bit >> 3] ^= 1 << (bit & 7)
      expect(imageDamage(damaged), `bit ${bit}`).toBeDefined()
    }
  })

  it('is detected if a PNG has no header', async () => {
    const bytes = await draw((own) => own.png())
    const end = bytes.subarray(bytes.length - 12)
    expect(imageDamage(Buffer.concat([bytes.subarray(0, 8), end]))).toBe('missing header')
  })

  it('is detected in a JPEG by a marker that does not exist', async () => {
    const bytes = await draw((own) => own.jpeg())
    const damaged = Buffer.concat([bytes.subarray(0, -2), Buffer.of(0xff, 0x30, 0xff, 0xd9)])
    expect(imageDamage(damaged)).toBe('unknown JPEG marker')
  })
})

import { DataArrayTexture, LinearFilter, LinearMipmapLinearFilter, SRGBColorSpace } from 'three'
import { describe, expect, it } from 'vitest'
import { MipChain } from '../../../packages/furrow/src/three/update/mip-chain.ts'
import { seeded } from '../../random.ts'

const SLICE = 1

function arrayTexture(width: number, height: number, channels: number, colorSpace = '') {
  const random = seeded(11)
  const data = Uint8Array.from({ length: 2 * width * height * channels }, () => random() * 256)
  const texture = new DataArrayTexture(data, width, height, 2)
  texture.minFilter = LinearMipmapLinearFilter
  texture.colorSpace = colorSpace
  return { texture, data: data.subarray(width * height * channels) }
}

const decode = (byte: number) => {
  const value = byte / 255
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4
}
const encode = (light: number) =>
  255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055)

describe('the mipmaps of a changed slice', () => {
  it.each([
    [16, 16, 4],
    [32, 4, 1],
    [1, 8, 4],
  ])('halve %i x %i texels of %i channels down to one', (width, height, channels) => {
    const { texture, data } = arrayTexture(width, height, channels)
    const { levels } = new MipChain(texture, SLICE)
    expect([...levels[0].data]).toEqual([...data])
    expect(levels.length).toBe(Math.log2(Math.max(width, height)) + 1)
    for (let i = 1; i < levels.length; i++) {
      const [from, to] = [levels[i - 1], levels[i]]
      expect([to.width, to.height]).toEqual([from.width, from.height].map((side) => Math.max(1, side / 2)))
      for (let k = 0; k < to.data.length; k++) {
        const [x, y, c] = [
          Math.floor(k / channels) % to.width,
          Math.floor(k / channels / to.width),
          k % channels,
        ]
        const at = (dx: number, dy: number) => {
          const column = Math.min(2 * x + dx, from.width - 1)
          return from.data[(Math.min(2 * y + dy, from.height - 1) * from.width + column) * channels + c]
        }
        const mean = (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4
        expect(Math.abs(to.data[k] - mean)).toBeLessThanOrEqual(0.5)
        if (mean % 1 === 0.5) expect(to.data[k] % 2).toBe(0)
      }
    }
  })

  it('average colours as linear light, and opacity as stored', () => {
    const { texture, data } = arrayTexture(8, 8, 4, SRGBColorSpace)
    const [, half] = new MipChain(texture, SLICE).levels
    for (let c = 0; c < 4; c++) {
      const four = [0, 4, 32, 36].map((at) => data[at + c])
      const mean = (numbers: number[]) => numbers.reduce((sum, number) => sum + number, 0) / 4
      const exact = c < 3 ? encode(mean(four.map(decode))) : mean(four)
      expect(Math.abs(half.data[c] - exact)).toBeLessThanOrEqual(0.6)
    }
  })

  it.each([
    { x0: 5, y0: 3, x1: 9, y1: 4 },
    { x0: 0, y0: 0, x1: 1, y1: 1 },
    { x0: 15, y0: 15, x1: 16, y1: 16 },
  ])("are the same when only a rectangle's are recomputed: %j", (bounds) => {
    const { texture, data } = arrayTexture(16, 16, 4)
    const chain = new MipChain(texture, SLICE)
    for (let y = bounds.y0; y < bounds.y1; y++)
      for (let x = bounds.x0; x < bounds.x1; x++) data.fill(7, 4 * (16 * y + x), 4 * (16 * y + x) + 4)
    const touched = chain.update(bounds)
    expect(touched).toHaveLength(5)
    expect(touched[4]).toEqual({ x0: 0, y0: 0, x1: 1, y1: 1 })
    const whole = new MipChain(texture, SLICE)
    expect(chain.levels.map((level) => [...level.data])).toEqual(whole.levels.map((level) => [...level.data]))
  })

  it('are left to the GPU if a side is not a power of two, and do not exist without a mipmap filter', () => {
    expect(new MipChain(arrayTexture(12, 16, 1).texture, SLICE).levels).toHaveLength(1)
    const { texture } = arrayTexture(16, 16, 1)
    texture.minFilter = LinearFilter
    expect(new MipChain(texture, SLICE).levels).toHaveLength(1)
  })
})

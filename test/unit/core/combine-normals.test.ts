import * as fc from 'fast-check'
import { combineNormals, type RgbaImage } from 'furrow/author'
import { describe, expect, it } from 'vitest'

const texel = (...rgb: number[]): RgbaImage => ({ width: 1, height: 1, data: Uint8Array.from([...rgb, 255]) })
const FLAT = [128, 128, 255]

/** Returns the bytes of a normal that is tilted by `degrees` towards `direction`, degrees from +X. */
function tilted(degrees: number, direction: number): number[] {
  const [a, b] = [(degrees * Math.PI) / 180, (direction * Math.PI) / 180]
  return [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)].map((n) =>
    Math.round((n + 1) * 127.5),
  )
}

const tiltOf = ([x, y, z]: ArrayLike<number> & Iterable<number>) =>
  (Math.atan2(Math.hypot(x - 128, y - 128), z - 127.5) * 180) / Math.PI

describe('combineNormals', () => {
  it('keeps the base bit for bit under a flat detail, and the detail on a flat base', () => {
    const byte = fc.integer({ min: 0, max: 255 })
    fc.assert(
      fc.property(fc.tuple(byte, byte, byte), (rgb) => {
        expect([...combineNormals(texel(...rgb), texel(...FLAT)).data]).toEqual([...rgb, 255])
        expect([...combineNormals(texel(...FLAT), texel(...rgb)).data]).toEqual([...rgb, 255])
      }),
    )
  })

  it('adds the angles of two tilts in one direction', () => {
    for (const direction of [0, 60, 135, 200, 330]) {
      const { data } = combineNormals(texel(...tilted(20, direction)), texel(...tilted(25, direction)))
      expect(Math.abs(tiltOf(data.subarray(0, 3)) - 45)).toBeLessThan(0.7)
    }
  })

  it('cancels opposite tilts', () => {
    const { data } = combineNormals(texel(...tilted(30, 45)), texel(...tilted(30, 225)))
    expect(tiltOf(data.subarray(0, 3))).toBeLessThan(0.7)
  })

  it('keeps the angle between base and result equal to the tilt of the detail', () => {
    const degrees = fc.double({ min: 2, max: 50, noNaN: true })
    const direction = fc.double({ min: 0, max: 360, noNaN: true })
    fc.assert(
      fc.property(degrees, direction, degrees, direction, (a, da, b, db) => {
        const base = tilted(a, da)
        const { data } = combineNormals(texel(...base), texel(...tilted(b, db)))
        const [p, q] = [base, [...data.subarray(0, 3)]].map((rgb) => rgb.map((c) => c / 127.5 - 1))
        const dot = p.reduce((sum, n, k) => sum + n * q[k], 0) / (Math.hypot(...p) * Math.hypot(...q))
        expect(Math.abs((Math.acos(Math.min(dot, 1)) * 180) / Math.PI - b)).toBeLessThan(1.2)
      }),
    )
  })

  it('does not modify its inputs, and refuses maps of unequal size', () => {
    const base = texel(...tilted(10, 0))
    const detail: RgbaImage = { width: 2, height: 1, data: new Uint8Array(8) }
    expect(() => combineNormals(base, detail)).toThrow(
      'combineNormals: size of the detail map differs from the base map, got "2 x 1", allowed: 1 x 1; render the detail map at the size of the base map, or scale the base map',
    )
    const before = [...base.data]
    combineNormals(base, texel(...tilted(10, 90)))
    expect([...base.data]).toEqual(before)
  })
})

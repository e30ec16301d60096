import { parseStrokes, strokesToOnset } from 'furrow/author'
import { reference } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { flatCanvas } from './planes.ts'

/** Texels per side. The sheet is 64 mm wide, so a texel is a quarter of a millimetre. */
const SIZE = 256
const canvas = flatCanvas(64, 64, SIZE)
const strokesOf = (...list: object[]) => parseStrokes({ version: 1, strokes: list }).strokes
const line = (v: number, more: object = {}) => ({
  group: 'brow',
  points: [
    [0.2, v],
    [0.8, v],
  ],
  width: 2,
  depth: 0.6,
  taper: [0.4, 0.4],
  ...more,
})
const at = ({ data }: { data: Uint8Array }, u: number, v: number) =>
  data[Math.floor(u * SIZE) + Math.floor(v * SIZE) * SIZE]

describe('the onset map of strokes', () => {
  it('is 0.04 at the deepest point, 0.5 at the ends, and 0 away from strokes', () => {
    const map = strokesToOnset(strokesOf(line(0.5)), canvas)
    expect(at(map, 0.5, 0.5)).toBe(10)
    expect(at(map, 0.2, 0.5)).toBeGreaterThan(124)
    expect(at(map, 0.8, 0.5)).toBeGreaterThan(124)
    expect(at(map, 0.5, 0.1)).toBe(0)
    const along = [0.5, 0.45, 0.4, 0.35, 0.3, 0.25, 0.2].map((u) => at(map, u, 0.5))
    expect(along).toEqual(along.toSorted((a, b) => a - b))
  })

  it('shows the middle of a line at activation 0.3, and hides its ends', () => {
    const map = strokesToOnset(strokesOf(line(0.5)), canvas)
    const shown = (u: number) => reference.onsetInfluence(0.3, at(map, u, 0.5) / 255)
    expect(shown(0.5)).toBeGreaterThanOrEqual(0.4)
    for (const end of [0.2, 0.8]) expect(shown(end)).toBeLessThanOrEqual(0.1)
  })

  it('is constant across the width of a line', () => {
    const map = strokesToOnset(strokesOf(line(0.5)), canvas)
    for (const u of [0.3, 0.5, 0.6]) {
      for (const offset of [-6, -3, 3, 6]) {
        expect(Math.abs(at(map, u, 0.5 + offset / SIZE) - at(map, u, 0.5))).toBeLessThanOrEqual(1)
      }
    }
  })

  it('ignores bulges', () => {
    const bulge = { ...line(0.5), depth: -3, width: 30 }
    expect(strokesToOnset(strokesOf(line(0.5), bulge), canvas)).toEqual(
      strokesToOnset(strokesOf(line(0.5)), canvas),
    )
    expect(strokesToOnset(strokesOf(bulge), canvas).data.every((onset) => onset === 0)).toBe(true)
  })

  it('compares the strokes of a group with its deepest stroke', () => {
    const [deep, shallow] = [line(0.25), line(0.75, { depth: 0.3 })]
    const map = strokesToOnset(strokesOf(deep, shallow), canvas)
    expect(at(map, 0.5, 0.25)).toBe(10)
    // Half as deep: 0.04 + 0.46 / 2.
    expect(at(map, 0.5, 0.75)).toBe(Math.round(255 * 0.27))
    const separate = strokesToOnset(strokesOf(deep, { ...shallow, group: 'chin' }), canvas)
    expect(at(separate, 0.5, 0.75)).toBe(10)
  })

  it('does not depend on the order of strokes', () => {
    const strokes = strokesOf(line(0.5), line(0.52, { depth: 0.4 }), line(0.47, { depth: 0.2 }))
    expect(strokesToOnset(strokes.toReversed(), canvas).data).toEqual(strokesToOnset(strokes, canvas).data)
  })
})

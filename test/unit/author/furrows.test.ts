import { parseStrokes, skinCanvas, strokesToHeight } from 'furrow/author'
import { addFurrows, FINE_FURROW_DEFAULTS, type FurrowRegion } from 'furrow/internal'
import { describe, expect, test } from 'vitest'
import { furrowHeights } from '../../../packages/furrow/src/author/furrows/furrows.ts'
import { across } from '../../strokes.ts'
import { flatCanvas, joined, same, sheet } from './planes.ts'

const SIDE = 40
const SIZE = 400
/** Texels per millimetre. */
const TEXELS = SIZE / SIDE
const FURROWS = { ...FINE_FURROW_DEFAULTS, size: 2, depth: 0.1 }

/** Stroke across the middle of the sheet. It has no depth, and only gives furrows their direction. */
const level = parseStrokes({
  version: 1,
  strokes: [
    {
      points: across(0.5, 0.02, 0.98),
      width: 1,
      depth: 0,
    },
  ],
}).strokes

/** Counts the texels at about half depth. The furrows that divide large cells have this depth. */
const between = (data: Float32Array) => data.filter((height) => height < -0.03 && height > -0.05).length

const lowestOf = (data: Float32Array) => data.reduce((low, height) => Math.min(low, height))

/** Furrows deeper than this fraction of the greatest depth are those around large cells. */
const LARGE = 0.46

/** Returns the mean distance between the furrows around large cells, millimetres, along rows or columns near the middle. */
function spacing(data: Float32Array, along: 'rows' | 'columns'): number {
  let [length, count] = [0, 0]
  for (let line = 150; line < 250; line++) {
    let isInside = false
    for (let i = 0; i < SIZE; i++) {
      const isFurrow = data[along === 'rows' ? line * SIZE + i : i * SIZE + line] < -LARGE * FURROWS.depth
      if (isFurrow && !isInside) count++
      isInside = isFurrow
    }
    length += SIDE
  }
  return length / count
}

/** Finds connected patches of texels whose heights pass a test, and returns the number of texels in each. */
function patches(data: Float32Array, isIn: (height: number) => boolean): number[] {
  const left = new Set([...data.keys()].filter((texel) => isIn(data[texel])))
  const sizes: number[] = []
  for (const first of left) {
    left.delete(first)
    const patch = [first]
    for (const texel of patch) {
      for (const next of [texel - 1, texel + 1, texel - SIZE, texel + SIZE])
        if (left.delete(next)) patch.push(next)
    }
    sizes.push(patch.length)
  }
  return sizes
}

describe('furrowHeights', () => {
  const canvas = flatCanvas(SIDE, SIDE, SIZE)
  const { data } = furrowHeights(canvas, FURROWS)

  test('covers the skin with furrows about a cell apart, within the stated depth', () => {
    expect(lowestOf(data)).toBeCloseTo(-0.1, 2)
    expect(data.every((height) => height <= 0)).toBe(true)
    for (const along of ['rows', 'columns'] as const) {
      expect(spacing(data, along)).toBeGreaterThan(0.7 * FURROWS.size)
      expect(spacing(data, along)).toBeLessThan(1.5 * FURROWS.size)
    }
  })

  test('is deterministic, and differs with another seed', () => {
    expect(same(furrowHeights(canvas, FURROWS).data, data)).toBe(true)
    expect(same(furrowHeights(canvas, { ...FURROWS, seed: 2 }).data, data)).toBe(false)
  })

  test('divides large cells into smaller ones by shallower furrows', () => {
    expect(between(data) / data.length).toBeGreaterThan(0.05)
  })

  test('has gaps in furrows, because closed cells would look like scales', () => {
    const cell = (FURROWS.size * TEXELS) ** 2
    const closed = patches(data, (height) => height > -LARGE * FURROWS.depth).filter(
      (texels) => texels > cell / 4 && texels < 2 * cell,
    )
    expect(closed.length / (SIDE / FURROWS.size) ** 2).toBeLessThan(0.2)
  })

  test('has cells elongated along the lines of the skin', () => {
    const heights = strokesToHeight(level, canvas)
    addFurrows(heights, canvas, { ...FURROWS, stretch: 2 }, level)
    expect(spacing(heights.data, 'rows') / spacing(heights.data, 'columns')).toBeGreaterThan(1.25)
    expect(spacing(data, 'rows') / spacing(data, 'columns')).toBeLessThan(1.15)
  })

  test('continues across seams of the texture', () => {
    // The left half of the sheet stays in place. The right half becomes a separate island, moved up by a quarter of the texture.
    const left = sheet([SIDE, 0, 0], [0, -SIDE, 0], [0, 0.5, 0.5, 1])
    const right = sheet([SIDE, 0, 0], [0, -SIDE, 0], [0.5, 0.5, 1, 1])
    const uvs = Array.from(right.uvs, (value, k) => (k % 2 === 1 ? value - 0.25 : value))
    const cut = skinCanvas(joined(left, { ...right, uvs }), SIZE)
    const moved = furrowHeights(cut, FURROWS).data
    for (let row = 220; row < 380; row++) {
      expect(moved[row * SIZE + 190]).toBeCloseTo(data[row * SIZE + 190], 6)
      expect(moved[(row - 100) * SIZE + 210]).toBeCloseTo(data[row * SIZE + 210], 6)
    }
  })

  test('has less than half the depth on texels of 1 mm, which are wider than the furrows', () => {
    const coarse = furrowHeights(flatCanvas(SIDE, SIDE, 40), FURROWS).data
    expect(lowestOf(coarse)).toBeGreaterThan(-0.05)
  })

  test('leaves out the furrows that are narrower than two texels, and no others', () => {
    // Furrows around large cells are 0.6 mm wide, those around small cells 0.27 mm.
    expect(lowestOf(furrowHeights(flatCanvas(SIDE, SIDE, 100), FURROWS).data)).toBe(0)
    const { data } = furrowHeights(flatCanvas(SIDE, SIDE, 150), FURROWS)
    expect(lowestOf(data)).toBeCloseTo(-0.1, 2)
    const own = furrowHeights(flatCanvas(SIDE, SIDE, 150), { ...FURROWS, size: 2 / 0.45 })
    expect(lowestOf(own.data)).toBeCloseTo(-0.1, 2)
    expect(between(data)).toBeLessThan(between(own.data))
  })

  describe('in regions', () => {
    const regions: FurrowRegion[] = [
      { at: [0.2, 0.5], radius: 8, size: 1, depth: 0.05 },
      { at: [0.7, 0.5], radius: 12, size: 3, depth: 0.1 },
    ]
    const drawn = furrowHeights(canvas, { ...FURROWS, regions }).data
    const column = (column: number) =>
      Float32Array.from({ length: SIZE }, (_, row) => drawn[row * SIZE + column])

    test('furrows cover only these regions, with the depth of each region', () => {
      expect(lowestOf(drawn.filter((_, texel) => texel % SIZE < 160))).toBeCloseTo(-0.05, 2)
      expect(lowestOf(drawn)).toBeCloseTo(-0.1, 2)
      const outside: number[] = []
      for (let row = 0; row < SIZE; row++) {
        for (let at = 0; at < SIZE; at++) {
          const inside = regions.some(
            ({ at: [u, v], radius }) =>
              Math.hypot((at + 0.5) / SIZE - u, (row + 0.5) / SIZE - v) * SIDE < radius,
          )
          if (!inside) outside.push(Math.abs(drawn[row * SIZE + at]))
        }
      }
      expect(outside.filter((depth) => depth > 1e-9)).toEqual([])
    })

    test('each region has cells of the size that it states', () => {
      const [fine, coarse] = regions.map(({ at: [u], depth }) => {
        const middle = u * SIZE
        let count = 0
        for (let at = middle - 30; at < middle + 30; at++) {
          const heights = column(at).subarray(SIZE / 2 - 35, SIZE / 2 + 35)
          const isLarge = (height: number) => height < -LARGE * depth
          count += heights.filter((height, i) => isLarge(height) && !isLarge(heights[i - 1])).length
        }
        return count
      })
      expect(fine / coarse).toBeGreaterThan(2)
      expect(fine / coarse).toBeLessThan(4.5)
    })
  })
})

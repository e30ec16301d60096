import { describe, expect, it } from 'vitest'
import {
  type BorderEdge,
  copyNearest,
  dilate,
  extendPlanes,
} from '../../../packages/furrow/src/author/border.ts'
import { seeded } from '../../random.ts'

/** Returns a map of 7 x 5 texels in which only the middle texel has a value. */
function dot() {
  const known = new Uint8Array(35)
  const data = new Float32Array(70)
  known[17] = 1
  data.set([4, -2], 34)
  return { known, maps: [{ data, channels: 2 }] as const }
}

const rows = (known: Uint8Array) =>
  Array.from({ length: 5 }, (_, y) => known.slice(7 * y, 7 * y + 7).join(''))

describe('dilate', () => {
  it('fills the given number of texels in all directions', () => {
    const { known, maps } = dot()
    dilate(known, 7, maps, 1)
    expect(rows(known)).toEqual(['0000000', '0011100', '0011100', '0011100', '0000000'])
    dilate(known, 7, maps, 1)
    expect(rows(known)).toEqual(['0111110', '0111110', '0111110', '0111110', '0111110'])
    expect(
      known.every((value, i) => !value || (maps[0].data[2 * i] === 4 && maps[0].data[2 * i + 1] === -2)),
    ).toBe(true)
  })

  it('stops at the border of the map, and does nothing if no texel or every texel is known', () => {
    const { known, maps } = dot()
    dilate(known, 7, maps, 100)
    expect(known.every((value) => value === 1)).toBe(true)
    const before = maps[0].data.slice()
    dilate(known, 7, maps, 100)
    expect(maps[0].data).toEqual(before)
    const nothing = new Uint8Array(35)
    dilate(nothing, 7, [{ data: new Float32Array(35), channels: 1 }], 5)
    expect(nothing.every((value) => value === 0)).toBe(true)
  })

  it('averages only texels that were known before the current ring, in any order', () => {
    const known = Uint8Array.from([1, 0, 1, 0, 0])
    const data = Float32Array.from([2, 0, 6, 0, 0])
    dilate(known, 5, [{ data, channels: 1 }], 1)
    expect([...data]).toEqual([2, 4, 6, 6, 0])
    dilate(known, 5, [{ data, channels: 1 }], 1)
    expect([...data]).toEqual([2, 4, 6, 6, 6])
  })
})

describe('copyNearest', () => {
  it('gives every texel the value of the nearest known texel', () => {
    const known = Uint8Array.of(1, 0, 0, 0, 0, 0, 0, 0, 0, 1)
    const map = Float32Array.of(5, 0, 0, 0, 0, 0, 0, 0, 0, -3)
    copyNearest(known, 5, [map])
    expect([...map]).toEqual([5, 5, 5, -3, -3, 5, 5, -3, -3, -3])
    expect([...known]).toEqual([1, 0, 0, 0, 0, 0, 0, 0, 0, 1])
  })
})

describe('extendPlanes', () => {
  /** Returns the triangle of each texel in a map of 8 x 8, after `extendPlanes`. Before, triangle 0 has column 0 and triangle 1 column 7. */
  const extended = (margin: number) => {
    const owners = Int8Array.from({ length: 64 }, (_, texel) =>
      texel % 8 === 0 ? 0 : texel % 8 === 7 ? 1 : -1,
    )
    const isCovered = owners.map((owner) => (owner >= 0 ? 1 : 0))
    const edges = [0, 1].map((triangle) => ({ triangle, x: 7 * triangle, y: 0, dx: 0, dy: 7 }))
    extendPlanes(
      () => edges,
      8,
      8,
      margin,
      (texel) => isCovered[texel] === 0,
      (texel, triangle) => {
        owners[texel] = triangle
      },
    )
    return owners
  }

  it('gives texels to the nearest edge within the margin', () => {
    for (let row = 0; row < 8; row++) {
      expect([...extended(2).slice(8 * row, 8 * row + 8)]).toEqual([0, 0, 0, -1, -1, 1, 1, 1])
      expect([...extended(14).slice(8 * row, 8 * row + 8)]).toEqual([0, 0, 0, 0, 1, 1, 1, 1])
    }
  })

  /** Returns random edges, some of them beyond the map of 64 x 64 texels. */
  const edgesOf = (count: number, length: number, random = seeded(3)): BorderEdge[] =>
    Array.from({ length: count }, (_, triangle) => {
      const [x, y] = [72 * random() - 4, 72 * random() - 4]
      return { triangle, x, y, dx: length * (random() - 0.5), dy: length * (random() - 0.5) }
    })

  type Own = (texel: number, triangle: number) => void
  const extend = (edges: BorderEdge[], isFree: (texel: number) => boolean, own: Own = () => {}) =>
    extendPlanes(() => edges, 64, 64, 14, isFree, own)

  it.each([
    ['no', []],
    ['few long', edgesOf(8, 60)],
    ['few short', edgesOf(30, 1)],
    ['many', edgesOf(2000, 2)],
  ])('gives each texel to the nearest of %s edges', (_, edges) => {
    const isFree = (texel: number) => texel % 7 !== 0
    const owners = new Map<number, number>()
    extend(edges, isFree, (texel, triangle) => owners.set(texel, triangle))
    for (let texel = 0; texel < 64 * 64; texel++) {
      const distances = edges.map((edge) => distanceTo(edge, texel % 64, Math.floor(texel / 64)))
      const least = Math.min(...distances)
      const owner = owners.get(texel)
      if (!isFree(texel) || least > 14) expect(owner).toBeUndefined()
      else expect(distances[owner!]).toBeCloseTo(least, 5)
    }
  })

  it.each([
    ['side by side', edgesOf(20_000, 1)],
    ['in one texel', edgesOf(20_000, 1).map((edge) => ({ ...edge, x: 30.2, y: 30.2 }))],
  ])('visits few texels for each of 20,000 edges shorter than a texel, %s', (_, edges) => {
    let visits = 0
    extend(edges, () => ++visits > 0)
    expect(visits / edges.length).toBeLessThan(60)
  })
})

function distanceTo({ x, y, dx, dy }: BorderEdge, column: number, row: number): number {
  const along = ((column - x) * dx + (row - y) * dy) / (dx * dx + dy * dy)
  const t = Math.min(1, Math.max(0, along))
  return Math.hypot(column - x - t * dx, row - y - t * dy)
}

import { type BumpOptions, bumpToNormal } from 'furrow/author'
import { describe, expect, it } from 'vitest'

const heights = (width: number, height: number, f: (x: number, y: number) => number) => ({
  width,
  height,
  data: Float64Array.from({ length: width * height }, (_, i) => f(i % width, Math.floor(i / width))),
})

/** Returns the largest angle between the decoded normals and those of the slopes that `exact` returns, degrees. */
function worst(
  map: ReturnType<typeof heights>,
  options: BumpOptions,
  exact: (x: number, y: number) => [number, number],
): number {
  const { data } = bumpToNormal(map, options)
  const full = options.bits === 16 ? 65535 : 255
  let angle = 0
  for (let i = 0; i < map.width * map.height; i++) {
    const n = [0, 1, 2].map((k) => (2 * data[3 * i + k]) / full - 1)
    const [sx, sy] = exact(i % map.width, Math.floor(i / map.width))
    const e = [-sx, options.green === 'down' ? -sy : sy, 1]
    const cross = [n[1] * e[2] - n[2] * e[1], n[2] * e[0] - n[0] * e[2], n[0] * e[1] - n[1] * e[0]]
    angle = Math.max(angle, Math.asin(Math.hypot(...cross) / Math.hypot(...n) / Math.hypot(...e)))
  }
  return (angle * 180) / Math.PI
}

describe('bumpToNormal', () => {
  const plane = heights(12, 9, (x, y) => 0.5 * x - 0.25 * y)

  it.each(['up', 'down'] as const)('is exact on a plane up to its border, green %s', (green) => {
    expect(worst(plane, { green, bits: 16 }, () => [0.5, -0.25])).toBeLessThan(0.002)
    expect(worst(plane, { green, bits: 8 }, () => [0.5, -0.25])).toBeLessThan(0.33)
  })

  it('is exact on a paraboloid, including the border of the map', () => {
    const bowl = heights(20, 20, (x, y) => 0.01 * x * x + 0.02 * x * y - 0.03 * y * y)
    const slopes = (x: number, y: number): [number, number] => [0.02 * x + 0.02 * y, 0.02 * x - 0.06 * y]
    expect(worst(bowl, { bits: 16 }, slopes)).toBeLessThan(0.002)
  })

  it('continues on the other side at wrapped edges, and not at clamped ones', () => {
    const k = (2 * Math.PI) / 32
    const wave = heights(32, 32, (x, y) => 2 * Math.sin(k * x + 0.7) + Math.cos(2 * k * y))
    const slopes = (x: number, y: number): [number, number] => [
      2 * k * Math.cos(k * x + 0.7),
      -2 * k * Math.sin(2 * k * y),
    ]
    expect(worst(wave, { edges: 'wrap', bits: 16 }, slopes)).toBeLessThan(0.1)
    expect(worst(wave, { edges: 'clamp', bits: 16 }, slopes)).toBeGreaterThan(0.1)
    expect(worst(plane, { edges: 'wrap', bits: 16 }, () => [0.5, -0.25])).toBeGreaterThan(30)
  })

  it('mirrors green between the two conventions', () => {
    const up = bumpToNormal(plane).data
    const down = bumpToNormal(plane, { green: 'down' }).data
    for (let i = 0; i < up.length; i++) {
      // Negated values can differ by one step, because 0.5 is always rounded up.
      expect(Math.abs(i % 3 === 1 ? up[i] + down[i] - 255 : up[i] - down[i])).toBeLessThanOrEqual(1)
    }
    expect(up[1]).toBeLessThan(128)
  })

  it.each([
    [1, 1, [0, 0]],
    [2, 1, [3, 0]],
    [1, 2, [0, 5]],
    [3, 2, [3, 5]],
  ])('computes the slope of %d x %d texels', (width, height, slope) => {
    const tiny = heights(width, height, (x, y) => 3 * x + 5 * y)
    expect(worst(tiny, { bits: 16 }, () => slope as [number, number])).toBeLessThan(0.01)
  })

  it('is flat for constant heights, and reports progress up to the last row', () => {
    const progress: string[] = []
    const level = heights(3, 130, () => 7)
    const { data } = bumpToNormal(level, {}, (done, total) => progress.push(`${done}/${total}`))
    expect(data.every((value, i) => value === [128, 128, 255][i % 3])).toBe(true)
    expect(progress).toEqual(['64/130', '128/130', '130/130'])
  })

  it('refuses data that does not match its size', () => {
    expect(() => bumpToNormal({ width: 4, height: 4, data: [1, 2, 3] })).toThrow(
      'bumpToNormal: wrong number of heights, got 3, allowed: 16 for 4 x 4; give one height per texel',
    )
  })
})

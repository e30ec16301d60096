import { expect, it } from 'vitest'
import { HeightField } from '../../../packages/furrow/src/relief/height-fields.ts'
import { heightLevels } from '../../../packages/furrow/src/relief/height-levels.ts'
import { firstVertices } from '../../../packages/furrow/src/relief/welded-edges.ts'
import { sphere } from './coarse.ts'

/** A square of 10 mm and one of 40 mm. Each shows the complete texture. */
const squares = {
  positions: [0, 0, 0, 0.01, 0, 0, 0.01, 0.01, 0, 0, 0.01, 0, 1, 0, 0, 1.04, 0, 0, 1.04, 0.04, 0, 1, 0.04, 0],
  uvs: [0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1],
  triangles: [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7],
}

it('the mipmap level has texels half as wide as edges, or is the map itself', () => {
  const levels = heightLevels(
    squares,
    Uint32Array.from({ length: 8 }, (_, i) => i),
    0.002,
    {
      width: 128,
      height: 128,
    },
  )
  // On the first square a millimetre is 12.8 texels wide, on the second 3.2.
  for (const level of levels.subarray(0, 4)) expect(level).toBeCloseTo(Math.log2(12.8), 5)
  for (const level of levels.subarray(4)) expect(level).toBeCloseTo(Math.log2(3.2), 5)
  const coarse = heightLevels(squares, new Uint32Array(8), 0.002, { width: 4, height: 4 })
  expect([...coarse]).toEqual(new Array(8).fill(0))
})

it('vertices at one position have one level, and triangles without area or with NaN do no harm', () => {
  const mesh = sphere(0.05)
  const firstOf = firstVertices(mesh.positions)
  const levels = heightLevels(mesh, firstOf, 0.0012, { width: 2048, height: 1024 })
  for (const [i, first] of firstOf.entries()) expect(levels[i]).toBe(levels[first])
  expect(Math.max(...levels)).toBeGreaterThan(1)
  const broken = {
    positions: [0, 0, 0, 1, Number.NaN, 0, 0, 0, 0],
    uvs: [0, 0, 1, 0, 0, 1],
    triangles: [0, 1, 2, 0, 0, 2],
  }
  const found = heightLevels(broken, Uint32Array.of(0, 1, 2), 1, { width: 8, height: 8 })
  expect([...found]).toEqual([0, 0, 0])
})

it('a mipmap level averages texels, and fractional levels interpolate between two levels', () => {
  const data = Uint8Array.from({ length: 64 }, (_, i) => (i % 8 === 3 ? 255 : 127))
  const heights = { width: 8, height: 8, depth: 1, channels: 1 as const, data }
  const field = new HeightField({ slice: 0, amplitude: 0.255, areas: [] }, heights, null)
  const metres = (gray: number) => (gray - 127.5) / 1000
  expect(field.between(3, 4)).toBeCloseTo(metres(255), 9)
  expect(field.between(2.5, 4, 1)).toBeCloseTo(metres(191), 9)
  const [fine, coarse] = [field.between(3, 4), field.between(3, 4, 1)]
  expect(field.between(3, 4, 0.25)).toBeCloseTo(0.75 * fine + 0.25 * coarse, 9)
  expect(field.between(3, 4, 9)).toBeCloseTo(metres(143), 9)
})

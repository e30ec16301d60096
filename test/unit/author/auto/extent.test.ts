import { autoWrinkles } from 'furrow/author'
import { expect, test } from 'vitest'
import { PointGrid } from '../../../../packages/furrow/src/math/point-grid.ts'
import { seeded } from '../../../random.ts'
import { sheet } from './sheet.ts'

test('a skin that is too large for its area is refused', () => {
  const { positions, uvs, indices, offsets } = sheet(4, 20)
  const metres = (values: number[]) => values.map((value) => 0.001 * value)
  const needle = {
    positions: metres(positions),
    uvs,
    indices,
    targets: [{ name: 'press', offsets: metres(offsets) }],
  }
  needle.positions.push(0, 1e-30, 1e30)
  needle.uvs.push(0, 0)
  needle.targets[0].offsets.push(0, 0, 0)
  expect(() => autoWrinkles(needle, { size: 128 })).not.toThrow()
  needle.indices.push(needle.positions.length / 3 - 1, 0, 0)
  expect(() => autoWrinkles(needle, { size: 128 })).toThrow(/the mesh is too large for its area, got 1e\+30/)
})

test('the distance in a grid is found at any coordinate', () => {
  const grid = new PointGrid(6)
  grid.add([1, 2, 3])
  expect(grid.distance([1, 2, 4])).toBe(1)
  expect(grid.distance([-3, 2, 3])).toBe(4)
  expect(grid.distance([1e300, 0, 0])).toBeGreaterThan(6)
  expect(grid.distance([Number.NaN, 0, 0])).not.toBeLessThan(6)
})

test('the distance in a grid equals the distance to the nearest of many points, bit for bit', () => {
  const random = seeded(2)
  const points = Array.from({ length: 300 }, () => 6 * random())
  const grid = new PointGrid(6)
  grid.add(points)
  for (let i = 0; i < 50; i++) {
    const [x, y, z] = [6 * random(), 6 * random(), 6 * random()]
    const distances = points.flatMap((px, k) =>
      k % 3 === 0 ? [Math.hypot(px - x, points[k + 1]! - y, points[k + 2]! - z)] : [],
    )
    expect(grid.distance([x, y, z])).toBe(Math.min(...distances))
  }
})

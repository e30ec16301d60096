import { expect, test } from 'vitest'
import { HeadChart } from '../../../../packages/furrow/src/author/auto/surface/head-chart.ts'
import { weldSurface } from '../../../../packages/furrow/src/author/skin/surface.ts'
import { LineGrid } from '../../../../packages/furrow/src/author/strokes/line-grid.ts'

const LINE = {
  points: Float64Array.of(0, 0, 0, 1, 0, 0),
  normals: Float64Array.of(0, 0, 1, 0, 0, 1),
}

test('the search for wrinkle lines takes no longer in a huge triangle', () => {
  const grid = new LineGrid([LINE], [5])
  expect(grid.isNear([-1e9, -1e9, -1e9], [1e9, 1e9, 1e9])).toBe(true)
  expect(grid.isNear([-1e9, 1e6, -1e9], [1e9, 1e9, 1e9])).toBe(false)
})

test('the search finds wrinkle lines from all points within their reach, and from no others', () => {
  const grid = new LineGrid([LINE], [5])
  const found = (x: number, y: number, z: number) => {
    const distances: number[] = []
    grid.visit([x, y, z], [0, 0, 1], (_, distance) => distances.push(distance))
    return distances
  }
  expect(found(5.9, 0, 0)[0]).toBeCloseTo(4.9)
  expect(found(0.5, -4, 0)).toEqual([4])
  expect(found(6.1, 0, 0)).toEqual([])
  expect(found(1e9, 0, 0)).toEqual([])
  expect(found(Number.NaN, 0, 0)).toEqual([])
})

test('the time to search a skin for wrinkle lines grows linearly with its size', () => {
  const comparedPerPosition = (millimetres: number) => {
    const lines = Array.from({ length: millimetres / 10 }, (_, row) => {
      const points = Float64Array.from(
        { length: 3 * (millimetres / 10) },
        (_, i) => [i / 3, row, 0][i % 3]! * 10,
      )
      return { points, normals: points.map((_, i) => (i % 3 === 2 ? 1 : 0)) }
    })
    let compared = 0
    const reaches = new Proxy(new Array<number>(lines.length).fill(3), {
      get: (list, key: `${number}`) => {
        compared++
        return list[Number(key)]
      },
    })
    const grid = new LineGrid(lines, reaches)
    compared = 0
    for (let x = 0; x < millimetres; x += 10) {
      for (let y = 0; y < millimetres; y += 10) grid.visit([x, y, 0], [0, 0, 1], () => {})
    }
    return compared / (millimetres / 10) ** 2
  }
  expect(comparedPerPosition(800) / comparedPerPosition(200)).toBeLessThan(2)
})

test('the chart of a head accepts thousands of triangles that reach far above and below it', () => {
  const positions = [-5, -1e9, 0, 5, -1e9, 0, 0, 1e9, 0]
  const indices = Array.from({ length: 3 * 20_000 }, (_, i) => i % 3)
  const chart = new HeadChart(weldSurface({ positions, indices }))
  expect(chart.find([0, 0])?.position[1]).toBeCloseTo(0)
  expect(chart.find([0, 1e6])).toBeUndefined()
})

test('equal positions are welded in vertex order, including NaN', () => {
  const { pointOf, points } = weldSurface({
    positions: [0, 0, 0, 1, 0, 0, -0, 0, 0, Number.NaN, 0, 0, Number.NaN, 0, 0],
    indices: [],
  })
  expect([...pointOf]).toEqual([0, 1, 0, 2, 2])
  expect(points).toHaveLength(9)
})

test('four triangles that share an edge are linked in order', () => {
  const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1]
  const { adjacent } = weldSurface({ positions, indices: [0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 5] })
  expect([0, 3, 6, 9].map((edge) => adjacent[edge])).toEqual([1, 2, 3, 2])
})

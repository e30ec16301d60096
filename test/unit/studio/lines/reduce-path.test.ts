import { expect, test } from 'vitest'
import { splineAt } from '../../../../packages/furrow/src/math/spline.ts'
import { type PathPoint, reducePath } from '../../../../studio/src/lines/reduce-path.ts'

const point = (x: number, y: number): PathPoint => ({ position: [x, y, 0], uv: [x / 100, y / 100] })

/** Arc of 60 mm, with noise like the tremor of a hand. */
const arc = Array.from({ length: 200 }, (_, i) => {
  const t = (Math.PI * i) / 199
  return point(30 - 30 * Math.cos(t), 20 * Math.sin(t) + 0.1 * Math.sin(17 * i))
})

test('the path of a pointer becomes a spline of few points that follows it', () => {
  const reduced = reducePath(arc)
  expect(reduced.length).toBeGreaterThan(2)
  expect(reduced.length).toBeLessThan(12)
  expect([reduced[0], reduced.at(-1)]).toEqual([arc[0], arc.at(-1)])
  const knots = reduced.flatMap(({ position }) => position)
  const out = new Float64Array(3)
  for (let segment = 0; segment + 1 < reduced.length; segment++) {
    for (const t of [0.25, 0.5, 0.75]) {
      splineAt(out, knots, segment, t)
      const nearest = Math.min(...arc.map(({ position: [x, y] }) => Math.hypot(x - out[0], y - out[1])))
      expect(nearest).toBeLessThan(1)
    }
  }
})

test('a straight path has two points, however many the pointer reports', () => {
  const straight = Array.from({ length: 500 }, (_, i) => point(i / 10, 3))
  expect(reducePath(straight).length).toBe(2)
})

test('a path that returns to its start is a loop', () => {
  const loop = Array.from({ length: 101 }, (_, i) => {
    const t = (2 * Math.PI * (i % 100)) / 100
    return point(50 + 10 * Math.cos(t), 50 + 10 * Math.sin(t))
  })
  const reduced = reducePath(loop)
  expect(reduced.length).toBeGreaterThan(4)
  expect(reduced.at(-1)).toEqual(loop[0])
})

test.each([
  ['no points', []],
  ['a click', [point(5, 5)]],
  ['a click with a tremor', [point(5, 5), point(5.5, 5), point(5, 5.5), point(5.2, 5.9)]],
])('%s is no line', (_, path) => {
  expect(reducePath(path)).toEqual([])
})

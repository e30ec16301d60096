import { CubicBezierCurve, Vector2 } from 'three'
import { describe, expect, it } from 'vitest'
import { bezierAt } from '../../../packages/furrow/src/math/bezier.ts'
import { boundingBoxSize } from '../../../packages/furrow/src/math/bounds.ts'
import { hash32 } from '../../../packages/furrow/src/math/hash.ts'
import { isInsidePolygon } from '../../../packages/furrow/src/math/polygon.ts'
import { quadraticForm } from '../../../packages/furrow/src/math/quadratic-form.ts'
import { clamp, lerp, smoothstep } from '../../../packages/furrow/src/math/scalar.ts'
import { length2, length3 } from '../../../packages/furrow/src/math/vector.ts'
import { weldVertices } from '../../../packages/furrow/src/math/weld.ts'
import { seeded } from '../../random.ts'

it('bezierAt agrees with three.js', () => {
  const points = [
    [0, 0],
    [1, 3],
    [4, -2],
    [5, 1],
  ] as [number, number][]
  const curve = new CubicBezierCurve(
    ...(points.map((p) => new Vector2(...p)) as [Vector2, Vector2, Vector2, Vector2]),
  )
  const [a, b, c, d] = points
  for (const t of [0, 0.1, 0.5, 0.75, 1]) {
    const [x, y] = bezierAt(a, b, c, d, t)
    expect(x).toBeCloseTo(curve.getPoint(t).x, 12)
    expect(y).toBeCloseTo(curve.getPoint(t).y, 12)
  }
})

it('length2 and length3 are accurate for vectors of any size', () => {
  expect(length3(3, -4, 12)).toBe(13)
  expect(length2(-3, 4)).toBe(5)
  expect([length3(0, 0, 0), length2(0, 0)]).toEqual([0, 0])
  const next = seeded(1)
  for (let i = 0; i < 1000; i++) {
    const scale = 10 ** Math.round(400 * next() - 200)
    const [x, y, z] = Array.from(
      { length: 3 },
      () => scale * (2 * next() - 1) * 10 ** -Math.floor(4 * next()),
    )
    expect(Math.abs(length3(x, y, z) / Math.hypot(x, y, z) - 1)).toBeLessThan(3e-16)
    expect(Math.abs(length2(x, y) / Math.hypot(x, y) - 1)).toBeLessThan(3e-16)
  }
})

it('boundingBoxSize spans all points', () => {
  expect(boundingBoxSize([0, 5, 1, 2, -1, 1, -3, 0, 1])).toEqual([5, 6, 0])
})

it('hash32 returns the finaliser of MurmurHash3', () => {
  expect(hash32(0)).toBe(0)
  expect(hash32(1)).toBe(0x514e28b7)
  expect(hash32(-1)).toBe(0x81f16f39)
})

describe('isInsidePolygon', () => {
  const arrow = [
    [0, 0],
    [4, 0],
    [4, 4],
    [2, 1],
    [0, 4],
  ] as [number, number][]

  it.each([
    [1, 1, true],
    [3.5, 2, true],
    [2, 2, false],
    [5, 1, false],
    [-1, 0, false],
  ])('%f, %f: %s', (x, y, expected) => {
    expect(isInsidePolygon(arrow, x, y)).toBe(expected)
    expect(isInsidePolygon([...arrow].reverse(), x, y)).toBe(expected)
  })
})

it('quadraticForm is the squared length of a step on a sheared plane', () => {
  // Positions are `u * (3, 0) + v * (1, 2)`.
  expect(quadraticForm(9, 3, 5, 2, -1)).toBe(5 ** 2 + 2 ** 2)
})

it('scalars are clamped, mixed and smoothed', () => {
  expect([-1, 0.5, 3].map((x) => clamp(x, 0, 1))).toEqual([0, 0.5, 1])
  expect([0, 0.25, 1].map((t) => lerp(2, 6, t))).toEqual([2, 3, 6])
  expect([-1, 0, 0.25, 0.5, 1, 2].map(smoothstep)).toEqual([0, 0, 0.15625, 0.5, 1, 1])
})

it('weldVertices joins vertices with the same position', () => {
  const { pointOf, count } = weldVertices([0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1e-9])
  expect([...pointOf]).toEqual([0, 1, 0, 2])
  expect(count).toBe(3)
})

import { dot } from 'furrow/internal'
import { Triangle, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { barycentrics2, barycentrics3, interpolate } from '../../../packages/furrow/src/math/barycentrics.ts'
import { triangleNormal, uvArea, uvToTexels } from '../../../packages/furrow/src/math/triangle.ts'
import { cross, length, normalize } from '../../../packages/furrow/src/math/vector.ts'
import { seeded } from '../../random.ts'

const random = seeded(7)
const numbers = (count: number) => Float64Array.from({ length: count }, () => 2 * random() - 1)
const vector = (values: ArrayLike<number>, i = 0) =>
  new Vector3(values[3 * i], values[3 * i + 1], values[3 * i + 2])
const cases = Array.from({ length: 50 }, () => numbers(9))

describe('vectors', () => {
  it('agree with three.js', () => {
    for (const values of cases) {
      const [a, b] = [values.subarray(0, 3), values.subarray(3, 6)]
      const out = new Float64Array(3)
      cross(out, a, b)
      expect([...out]).toEqual(vector(a).cross(vector(b)).toArray())
      expect(dot(a, b)).toBe(vector(a).dot(vector(b)))
      expect(length(a)).toBeCloseTo(vector(a).length(), 14)
    }
  })

  it('are normalised in place, one of many', () => {
    const values = Float64Array.from([1, 2, 3, 0, 3, 4, 0, 0, 0])
    normalize(values, 3)
    expect([...values]).toEqual([1, 2, 3, 0, 0.6, 0.8, 0, 0, 0])
    normalize(values, 6)
    expect([...values.subarray(6)]).toEqual([0, 0, 0])
  })
})

describe('triangles', () => {
  it('have a normal of twice their area, facing their counterclockwise side', () => {
    const out = new Float64Array(3)
    triangleNormal(out, [9, 9, 9, 0, 0, 0, 2, 0, 0, 0, 3, 0], 1, 2, 3)
    expect([...out]).toEqual([0, 0, 6])
    for (const values of cases) {
      triangleNormal(out, values, 0, 1, 2)
      const triangle = new Triangle(vector(values), vector(values, 1), vector(values, 2))
      expect(length(out) / 2).toBeCloseTo(triangle.getArea(), 12)
      expect(dot(out, triangle.getNormal(new Vector3()).toArray())).toBeGreaterThan(0)
    }
  })

  it('have a positive area in the texture for both orientations', () => {
    const uvs = [0.5, 0.5, 0, 0, 1, 0, 0, 1]
    expect(uvArea(uvs, 1, 2, 3)).toBe(0.5)
    expect(uvArea(uvs, 1, 3, 2)).toBe(0.5)
    expect(uvArea(uvs, 1, 1, 2)).toBe(0)
  })

  it('are converted to texels, relative to the centre of the first texel', () => {
    const out = new Float64Array(6)
    uvToTexels(out, [0, 0, 0.25, 0.5, 1, 1], 0, 1, 2, 4, 2)
    expect([...out]).toEqual([-0.5, -0.5, 0.5, 0.5, 3.5, 1.5])
  })
})

describe('barycentric coordinates', () => {
  const weights = new Float64Array(3)

  it('reproduce the point, inside and outside a triangle of the plane', () => {
    for (const values of cases) {
      const [x, y] = [values[6], values[7]]
      barycentrics2(weights, values, x, y)
      expect(weights[0] + weights[1] + weights[2]).toBeCloseTo(1, 12)
      const out = new Float64Array(2)
      interpolate(out, values, 2, 0, 1, 2, weights[0], weights[1], weights[2])
      expect(out[0]).toBeCloseTo(x, 9)
      expect(out[1]).toBeCloseTo(y, 9)
    }
  })

  it("equal three.js's for a point beside a triangle in space", () => {
    for (const values of cases) {
      const point = numbers(3)
      barycentrics3(weights, values, 0, 1, 2, point)
      const expected = new Vector3()
      Triangle.getBarycoord(vector(point), vector(values), vector(values, 1), vector(values, 2), expected)
      for (let k = 0; k < 3; k++) expect(weights[k]).toBeCloseTo(expected.getComponent(k), 8)
    }
  })

  it('are not finite for a triangle without area', () => {
    barycentrics2(weights, [0, 0, 1, 1, 2, 2], 0, 1)
    expect([...weights].some((weight) => weight >= 0 && weight <= 1)).toBe(false)
    barycentrics3(weights, [0, 0, 0, 0, 0, 0, 1, 1, 1], 0, 1, 2, [0, 0, 1])
    expect([...weights].every(Number.isFinite)).toBe(false)
  })

  it('interpolate as many values as fit, with any stride', () => {
    const values = [1, 2, 3, 4, 5, 6, 7, 8, 10, 20, 30, 40]
    const out = new Float64Array(3)
    interpolate(out, values, 4, 0, 1, 2, 0.5, 0.25, 0.25)
    expect([...out]).toEqual([4.25, 7.5, 10.75])
  })
})

import { type HeightMap, heightToNormal } from 'furrow/author'
import { type Metric, surfaceMetric } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { slopeAt } from '../../../packages/furrow/src/author/normals/slope.ts'
import { seeded } from '../../random.ts'
import { degreesBetween, type Vector } from '../../vectors.ts'
import { flatMetric, sheet } from './planes.ts'

const SIDE = 256
const FLAT = [128, 128, 255, 255]

function heights(f: (u: number, v: number) => number, side = SIDE): HeightMap {
  const data = new Float32Array(side * side)
  for (let i = 0; i < data.length; i++) {
    data[i] = f(((i % side) + 0.5) / side, (Math.floor(i / side) + 0.5) / side)
  }
  return { width: side, height: side, data }
}

function worstAngle(map: HeightMap, metric: Metric, expected: (u: number, v: number) => Vector): number {
  const { data } = heightToNormal(map, metric)
  let worst = 0
  for (let y = 4; y < SIDE - 4; y++) {
    for (let x = 4; x < SIDE - 4; x++) {
      const i = 4 * (y * SIDE + x)
      const found: Vector = [data[i] / 127.5 - 1, data[i + 1] / 127.5 - 1, data[i + 2] / 127.5 - 1]
      worst = Math.max(worst, degreesBetween(found, expected((x + 0.5) / SIDE, (y + 0.5) / SIDE)))
    }
  }
  return worst
}

describe('heightToNormal', () => {
  it('is flat exactly where there is no slope', () => {
    const side = 24
    const next = seeded(3)
    for (let round = 0; round < 40; round++) {
      const map = heights(() => (next() < 0.01 ? 5 : 0), side)
      const { data } = heightToNormal(map, flatMetric(side, side, side))
      const wrong: [number, number][] = []
      for (let i = 0; i < side * side; i++) {
        const [x, y] = [i % side, Math.floor(i / side)]
        const slopes = [
          slopeAt(map.data, y * side, x, 1, side, 'clamp'),
          slopeAt(map.data, x, y, side, side, 'clamp'),
        ]
        const isFlat = slopes.every((slope) => Math.abs(slope) < 1e-3)
        const isDrawnFlat = FLAT.every((value, k) => data[4 * i + k] === value)
        if (isFlat !== isDrawnFlat) wrong.push([x, y])
      }
      expect(wrong).toEqual([])
    }
  })

  it('gives the slopes of a sine in both directions on a stretched sheet', () => {
    // The sheet has 200 x 80 mm, 8 waves along u with slopes up to 0.3, and 5 waves along v with slopes up to 0.5.
    const metric = flatMetric(200, 80, SIDE)
    const [ku, kv] = [2 * Math.PI * 8, 2 * Math.PI * 5]
    const [au, av] = [(0.3 * 200) / ku, (0.5 * 80) / kv]
    const map = heights((u, v) => au * Math.sin(ku * u) + av * Math.sin(kv * v))
    const worst = worstAngle(map, metric, (u, v) => [
      -0.3 * Math.cos(ku * u),
      // Green is positive towards smaller v. The normal of a surface that rises with v leans towards smaller v.
      0.5 * Math.cos(kv * v),
      1,
    ])
    expect(worst).toBeLessThan(0.5)
  })

  it('gives the slope of a cone in all directions', () => {
    const metric = flatMetric(100, 100, SIDE)
    const map = heights((u, v) => -0.7 * Math.hypot(100 * (u - 0.5), 100 * (v - 0.5)))
    const { data } = heightToNormal(map, metric)
    const worst = worstAngle(map, metric, (u, v) => {
      const r = Math.hypot(u - 0.5, v - 0.5)
      // Skips the tip, which has no normal.
      if (r < 0.02) {
        const i = 4 * (Math.floor(v * SIDE) * SIDE + Math.floor(u * SIDE))
        return [data[i] - 127.5, data[i + 1] - 127.5, data[i + 2] - 127.5]
      }
      return [(0.7 * (u - 0.5)) / r, (-0.7 * (v - 0.5)) / r, 1]
    })
    expect(worst).toBeLessThan(0.5)
  })

  it('uses the orthonormal frame of a sheared texture', () => {
    // Positions are `u * (100, 0, 0) + v * (50, -80, 0)` mm. In the tangent frame, x is along u, and y points towards smaller v.
    const metric = surfaceMetric(sheet([100, 0, 0], [50, -80, 0]), SIDE)
    // A plane that falls by 0.4 mm per mm along x and rises by 0.3 mm per mm along y.
    const map = heights((u, v) => -0.4 * (100 * u + 50 * v) + 0.3 * (-80 * v))
    expect(worstAngle(map, metric, () => [0.4, -0.3, 1])).toBeLessThan(0.3)
  })

  it("writes normals that three.js's derivative frame turns back into the slope", () => {
    // For positions `u * (100, 0, 0) + v * (50, -80, 0)`, grad u = (1, 0.625) / 100 and grad v = (0, -1) / 80.
    const metric = surfaceMetric(sheet([100, 0, 0], [50, -80, 0]), SIDE)
    const map = heights((u, v) => -0.4 * (100 * u + 50 * v) + 0.3 * (-80 * v))
    const { data } = heightToNormal(map, metric, 'derivative')
    const longer = Math.max(Math.hypot(1, 0.625) / 100, 1 / 80)
    const [tangent, bitangent] = [
      [1 / 100 / longer, 0.625 / 100 / longer],
      [0, 1 / 80 / longer],
    ] as const
    const i = 4 * (100 * SIDE + 100)
    const [x, y, z] = [data[i] / 127.5 - 1, data[i + 1] / 127.5 - 1, data[i + 2] / 127.5 - 1]
    expect((x * tangent[0] + y * bitangent[0]) / z).toBeCloseTo(0.4, 1.7)
    expect((x * tangent[1] + y * bitangent[1]) / z).toBeCloseTo(-0.3, 1.7)
  })

  it('gives the same map for both frames on a square texture', () => {
    const metric = flatMetric(100, 100, 64)
    const map = heights((u, v) => Math.sin(40 * u) + Math.cos(30 * v), 64)
    expect(heightToNormal(map, metric, 'derivative')).toEqual(heightToNormal(map, metric, 'orthonormal'))
  })

  it('refuses a metric of another size', () => {
    expect(() =>
      heightToNormal(
        heights(() => 0, 8),
        flatMetric(10, 10, 4),
      ),
    ).toThrow(
      'heightToNormal: height map and metric differ in size, got "8 x 8", allowed: 4 x 4, the size of the metric; measure the metric at the size of the height map',
    )
  })
})

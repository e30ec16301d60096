import { surfaceMetric } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { joined, sheet } from './planes.ts'

describe('surfaceMetric', () => {
  it('measures a sheared sheet exactly, in square millimetres', () => {
    const metric = surfaceMetric(sheet([100, 0, 0], [30, -40, 120]), 16, 8)
    for (let i = 0; i < 16 * 8; i++) {
      expect(metric.uu[i]).toBeCloseTo(100 * 100, 1)
      expect(metric.uv[i]).toBeCloseTo(100 * 30, 1)
      expect(metric.vv[i]).toBeCloseTo(30 * 30 + 40 * 40 + 120 * 120, 1)
      expect(metric.inside[i]).toBe(1)
    }
  })

  it('reads a mesh without indices as triples of vertices', () => {
    const positions = [0, 0, 0, 0, -0.05, 0, 0.1, 0, 0]
    const metric = surfaceMetric({ positions, uvs: [0, 0, 0, 1, 1, 0] }, 8)
    expect(metric.uu[0]).toBeCloseTo(10_000, 1)
    expect(metric.vv[0]).toBeCloseTo(2500, 1)
  })

  it('has the nearest values outside the islands, and marks those texels as outside', () => {
    const left = sheet([100, 0, 0], [0, -100, 0], [0, 0, 0.25, 1])
    const right = sheet([300, 0, 0], [0, -100, 0], [0.75, 0, 1, 1])
    const metric = surfaceMetric(joined(left, right), 32)
    const row = 5 * 32
    expect(Array.from(metric.inside.subarray(row, row + 32))).toEqual(
      Array.from({ length: 32 }, (_, x) => (x < 8 || x >= 24 ? 1 : 0)),
    )
    expect(metric.uu[row + 14]).toBeCloseTo(100 * 100, 1)
    expect(metric.uu[row + 17]).toBeCloseTo(300 * 300, 0)
  })

  it('uses the last island where islands overlap', () => {
    const [first, last] = [sheet([100, 0, 0], [0, -100, 0]), sheet([300, 0, 0], [0, -100, 0], [0, 0, 0.5, 1])]
    const metric = surfaceMetric(joined(first, last), 8)
    expect(Math.sqrt(metric.uu[8 + 1])).toBeCloseTo(300, 3)
    expect(Math.sqrt(metric.uu[8 + 6])).toBeCloseTo(100, 3)
  })

  it('stays within 0.2% of a cylinder cut into 64 strips', () => {
    const radius = 0.08
    const positions: number[] = []
    const uvs: number[] = []
    const indices: number[] = []
    for (let i = 0; i <= 64; i++) {
      const angle = (i / 64) * Math.PI
      for (const v of [0, 1]) {
        positions.push(-radius * Math.cos(angle), -0.2 * v, radius * Math.sin(angle))
        uvs.push(i / 64, v)
      }
      if (i < 64) indices.push(2 * i, 2 * i + 1, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 2)
    }
    const metric = surfaceMetric({ positions, uvs, indices }, 64)
    for (const i of [0, 1000, 64 * 64 - 1]) {
      expect(Math.sqrt(metric.uu[i]) / (1000 * radius * Math.PI)).toBeCloseTo(1, 2.7)
      expect(Math.sqrt(metric.vv[i])).toBeCloseTo(200, 3)
    }
  })

  it.each([
    [
      { positions: [0, 0, 0, 1], uvs: [] },
      'surfaceMetric: positions must have x, y and z per vertex, got 4, allowed: a multiple of 3, at least 9; check how the mesh was read',
    ],
    [
      { positions: new Float32Array(9), uvs: [0, 0, 1, 1] },
      'surfaceMetric: wrong number of texture coordinates, got 4, allowed: 6, two per vertex; check how the mesh was read',
    ],
    [
      { positions: [0, 0, Number.NaN, 1, 0, 0, 0, 1, 0], uvs: [0, 0, 1, 0, 0, 1] },
      'surfaceMetric: positions[2] is NaN or infinite, got NaN, allowed: finite metres; check how the mesh was read',
    ],
    [
      { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], uvs: [0, 0, 1, 0, 0, 1], indices: [0, 1, 3] },
      'surfaceMetric: indices[2] is out of range, got 3, allowed: 0..2; check how the mesh was read',
    ],
    [
      { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], uvs: [0.5, 0.5, 0.5, 0.5, 0.5, 0.5] },
      'surfaceMetric: no triangle of the mesh covers a texel of the map, allowed: texture coordinates within 0..1 and triangles with area; check that the mesh is unwrapped',
    ],
  ])('refuses %j', (mesh, message) => {
    expect(() => surfaceMetric(mesh, 16)).toThrow(message)
  })

  it('refuses an invalid size', () => {
    expect(() => surfaceMetric(sheet([1, 0, 0], [0, 1, 0]), 0.5)).toThrow(
      'surfaceMetric: invalid map size, got 0.5, allowed: whole numbers, 1..8192 texels; choose a common size such as 1024',
    )
  })
})

import { parseStrokes, type Stroke, skinCanvas, strokesToHeight } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { layOutStroke } from '../../../packages/furrow/src/author/strokes/lay-out.ts'
import { across } from '../../strokes.ts'
import { cylinder, folded, RADIUS, uvOf } from './skins.ts'

const strokesOf = (...list: object[]): Stroke[] => parseStrokes({ version: 1, strokes: list }).strokes
const ring = {
  curve: 'spline',
  points: [0.4, 0.6, 0.8, 1.1, 1.3, 1.6].map((turn) => uvOf(turn, 30)),
  width: 4,
  depth: 1,
  taper: 0,
}

describe('a stroke on a cylinder', () => {
  const SIZE = 512
  const canvas = skinCanvas(cylinder(), SIZE)
  const height = (data: Float32Array, [u, v]: [number, number]) =>
    data[Math.floor(v * SIZE) * SIZE + Math.floor(u * SIZE)]

  it('crosses a seam of the texture without a visible break', () => {
    const { data } = strokesToHeight(strokesOf(ring), canvas)
    for (let turn = 0.42; turn < 1.58; turn += 0.01) {
      expect(height(data, uvOf(turn, 30))).toBeLessThan(-0.93)
      for (const side of [-1, 1]) {
        // The skin is raised beside the valley, 3 half widths from its middle.
        expect(height(data, uvOf(turn, 30 + 6 * side))).toBeGreaterThan(0.02)
        expect(height(data, uvOf(turn, 30 + 20 * side))).toBe(0)
      }
    }
    expect(height(data, uvOf(0.05, 30))).toBe(0)
  })

  it('is laid on the skin in steps of at most half a millimetre', () => {
    const [line, ...others] = layOutStroke(strokesOf(ring)[0], canvas)
    expect(others).toEqual([])
    for (let i = 0; i < line.points.length; i += 3) {
      const [x, y, z] = line.points.subarray(i, i + 3)
      // The triangles are up to 0.01 mm inside the cylinder.
      expect(Math.abs(Math.hypot(x, z) - RADIUS)).toBeLessThan(0.02)
      expect(y).toBeCloseTo(30, 1)
      const [nx, ny, nz] = line.normals.subarray(i, i + 3)
      expect((x * nx + z * nz) / RADIUS).toBeGreaterThan(0.99)
      expect(Math.abs(ny)).toBeLessThan(0.01)
      if (i > 0)
        expect(
          Math.hypot(...line.points.subarray(i, i + 3).map((p, k) => p - line.points[i - 3 + k])),
        ).toBeLessThanOrEqual(0.51)
    }
    const length = (line.depths.length - 1) * 0.5
    expect(length).toBeGreaterThan(1.2 * Math.PI * RADIUS - 0.6)
    expect(length).toBeLessThan(1.2 * Math.PI * RADIUS + 0.6)
  })

  it('has its left and right as seen from outside, for any rotation of the UV island', () => {
    const { data } = strokesToHeight(strokesOf({ ...ring, shoulder: [1, 0] }), canvas)
    // Seen from outside, the stroke runs to the right, so its left is up.
    for (const turn of [0.6, 0.9, 1.2, 1.5]) {
      expect(height(data, uvOf(turn, 36))).toBeGreaterThan(0.02)
      expect(height(data, uvOf(turn, 26))).toBeLessThan(-0.02)
    }
  })

  it('follows its depth factors', () => {
    const { data } = strokesToHeight(strokesOf({ ...ring, depths: [0, 1, 0.5] }), canvas)
    for (const [turn, depth] of [
      [0.7, -0.5],
      [1, -1],
      [1.3, -0.75],
    ])
      expect(height(data, uvOf(turn, 30))).toBeCloseTo(depth, 1)
  })

  it.each(['polyline', 'bezier'])('is interrupted, as a %s, where the texture has no skin', (curve) => {
    const points = [0.2, 0.4, 0.6, 0.8].map((u) => [u, 0.5])
    const parts = layOutStroke(strokesOf({ ...ring, curve, points })[0], canvas)
    expect(parts.length).toBe(2)
    const { data } = strokesToHeight(strokesOf({ ...ring, curve, points }), canvas)
    expect(height(data, [0.3, 0.5])).toBeLessThan(-0.9)
    expect(height(data, [0.7, 0.5])).toBeLessThan(-0.9)
  })

  it('is not drawn if no part of it is on the skin', () => {
    for (const curve of ['polyline', 'spline']) {
      const points = [
        [0.01, 0.01],
        [0.99, 0.02],
      ]
      const { data } = strokesToHeight(strokesOf({ ...ring, curve, points }), canvas)
      expect(data.every((value) => value === 0)).toBe(true)
    }
  })

  it("measures millimetres by the document's scale", () => {
    const mesh = cylinder()
    const inCentimetres = { ...mesh, positions: Array.from(mesh.positions, (value) => 100 * value) }
    const scaled = skinCanvas(inCentimetres, SIZE, SIZE, 10)
    const [one, other] = [canvas, scaled].map((each) => strokesToHeight(strokesOf(ring), each).data)
    for (const [i, value] of one.entries())
      if (Math.abs(value - other[i]) > 1e-3) expect(other[i]).toBe(value)
  })
})

it('is drawn on the left half if both halves share texels', () => {
  const canvas = skinCanvas(folded(), 256)
  const stroke = strokesOf({
    ...ring,
    points: across(0.5, 0.2, 0.8),
  })
  for (const { points } of layOutStroke(stroke[0], canvas)) {
    for (let i = 0; i < points.length; i += 3) expect(points[i]).toBeGreaterThan(0)
  }
  const { data } = strokesToHeight(stroke, canvas)
  for (let column = 60; column < 200; column++) expect(data[128 * 256 + column]).toBeLessThan(-0.8)
})

it('finishes with finite heights on a mesh of any size', () => {
  for (const scale of [1e-6, 1, 1e6]) {
    const mesh = cylinder()
    const canvas = skinCanvas(mesh, 64, 64, 1000 * scale)
    const { data } = strokesToHeight(strokesOf({ ...ring, width: 50 }), canvas)
    expect(data.every(Number.isFinite)).toBe(true)
  }
})

import { surfaceMetric, UvLocator } from 'furrow/internal'
import { describe, expect, test } from 'vitest'
import { creaseLines } from '../../../../packages/furrow/src/author/auto/lines/crease.ts'
import { creaseDepth } from '../../../../packages/furrow/src/author/auto/lines/crease-depth.ts'
import { layFreeLines } from '../../../../packages/furrow/src/author/auto/lines/free-lines.ts'
import { STEP } from '../../../../packages/furrow/src/author/auto/lines/trace.ts'
import { smooth } from '../../../../packages/furrow/src/author/auto/strain/smooth.ts'
import { compressionTensors } from '../../../../packages/furrow/src/author/auto/surface/tensors.ts'
import { SkinTexels } from '../../../../packages/furrow/src/author/skin/skin-texels.ts'
import { drawStrokes } from '../../../../packages/furrow/src/author/strokes/height.ts'
import { COMPRESSION, SIDE, sheet } from './sheet.ts'

const SIZE = 448

describe.each([
  [20, 0, 6],
  [20, 25, 6],
  [7, 70, 9],
  [40, 45, 5],
])('a sheet of %d squares a side, shortened at %d degrees, spacing %d mm', (n, degrees, spacing) => {
  const { surface, positions, uvs, indices, offsets, cosine, sine } = sheet(n, degrees)
  const tensors = compressionTensors(surface, offsets)
  smooth(surface, tensors, 3)
  const style = { width: spacing / 2, depth: 1, taper: [0, 0], shoulder: [0.9, 0.9], softness: 0.5 } as const
  const lines = layFreeLines(surface, tensors, {
    spacing,
    minCompression: 0.05,
    maxTotalLength: Infinity,
    style,
  })

  test('has lines perpendicular to the compression, within 5 degrees', () => {
    for (const { points } of lines) {
      const [x, y] = [0, 1].map((k) => points[points.length - 3 + k] - points[k])
      const off = (Math.asin(Math.abs(x * cosine + y * sine) / Math.hypot(x, y)) * 180) / Math.PI
      expect(off).toBeLessThan(5)
    }
  })

  test('has lines at the requested spacing', () => {
    const distances = lines.map(({ points }) => {
      const middle = 3 * Math.floor(points.length / 6)
      return (points[middle] - SIDE / 2) * cosine + (points[middle + 1] - SIDE / 2) * sine
    })
    const gaps = distances
      .sort((a, b) => a - b)
      .flatMap((value, i) => (i > 0 ? [value - distances[i - 1]] : []))
    expect(gaps.length).toBeGreaterThan(SIDE / spacing / 2)
    expect(Math.min(...gaps)).toBeGreaterThan(0.85 * spacing)
    expect(Math.max(...gaps)).toBeLessThan(1.15 * spacing)
  })

  test('has a profile that is longer by the length that the sheet loses', () => {
    const skin = { positions, uvs, indices, targets: [] }
    const locator = new UvLocator(skin, surface)
    const { creases, compression } = creaseLines(
      { surface, locator, isDrawn: () => true },
      { name: 'sheet', spacing, creasedFraction: 1, maxDepth: Infinity },
      lines,
      { strength: 1, symmetry: 0 },
    )
    expect(compression).toBeCloseTo(COMPRESSION, 3)
    const texels = new SkinTexels(skin, surface, SIZE, SIZE)
    const { data } = drawStrokes(creases, { texels, metric: surfaceMetric(skin, SIZE, SIZE, 1) }).heights
    const texel = SIDE / SIZE
    let [length, count] = [0, 0]
    for (let row = 130; row < SIZE - 130; row++) {
      for (let column = 130; column < SIZE - 130; column++) {
        const i = row * SIZE + column
        const slope =
          ((data[i + 1] - data[i - 1]) * cosine - (data[i + SIZE] - data[i - SIZE]) * sine) / (2 * texel)
        length += Math.hypot(1 - COMPRESSION, slope)
        count++
      }
    }
    const taken = (length / count - (1 - COMPRESSION)) / COMPRESSION
    expect(taken).toBeGreaterThan(0.9)
    expect(taken).toBeLessThan(1.1)
  })
})

test('rigid motion causes no strain', () => {
  const { surface } = sheet(5, 0)
  const turned = Float64Array.from(surface.points, (value, i) => {
    const [x, z] = [surface.points[3 * Math.floor(i / 3)], 0]
    return [Math.cos(1) * x - Math.sin(1) * z + 7, surface.points[i] - 3, Math.sin(1) * x + 2][i % 3] - value
  })
  for (const value of compressionTensors(surface, turned)) expect(Math.abs(value)).toBeLessThan(1e-12)
})

test('depth grows with compression from zero', () => {
  const depths = [0, 0.05, 0.1, 0.2, 0.4].map((compression) =>
    creaseDepth(compression, 6, 1.5, { shoulder: [0.9, 0.9], banks: [4, 4], lean: 0, softness: 0.5 }),
  )
  expect(depths[0]).toBeLessThan(0.001)
  for (let i = 1; i < depths.length; i++) expect(depths[i]).toBeGreaterThan(depths[i - 1])
})

test('no lines are added beyond their maximum total length', () => {
  const { surface, offsets } = sheet(20, 0)
  const tensors = compressionTensors(surface, offsets)
  const style = { width: 3, depth: 1, taper: [0, 0], shoulder: [0.9, 0.9], softness: 0.5 } as const
  const lengthOf = (maxTotalLength: number) =>
    layFreeLines(surface, tensors, { spacing: 6, minCompression: 0.05, maxTotalLength, style }).reduce(
      (sum, { triangles }) => sum + STEP * triangles.length,
      0,
    )
  expect(lengthOf(Infinity)).toBeGreaterThan(6 * SIDE)
  expect(lengthOf(4.5 * SIDE)).toBeLessThan(4.5 * SIDE)
  expect(lengthOf(4.5 * SIDE)).toBeGreaterThan(3 * SIDE)
})

import { expect, test } from 'vitest'
import {
  type FlatChart,
  flatChart,
  liftPoint,
} from '../../../../../packages/furrow/src/author/auto/buckling/flat-chart.ts'
import {
  sampleChart,
  sampleTensors,
} from '../../../../../packages/furrow/src/author/auto/buckling/sample-chart.ts'
import { TENSOR_SIZE } from '../../../../../packages/furrow/src/author/auto/surface/tensors.ts'
import { weldSurface } from '../../../../../packages/furrow/src/author/skin/surface.ts'

const SIDE = 16
const RADIUS = 30

/** Returns a patch of a cylinder around the y axis, 60 mm along the arc and 60 mm high, in millimetres. */
function patch() {
  const positions: number[] = []
  const indices: number[] = []
  for (let row = 0; row <= SIDE; row++) {
    for (let column = 0; column <= SIDE; column++) {
      const angle = 2 * (column / SIDE - 0.5)
      positions.push(RADIUS * Math.sin(angle), 60 * (row / SIDE - 0.5), RADIUS * Math.cos(angle))
      if (row === SIDE || column === SIDE) continue
      const i = row * (SIDE + 1) + column
      indices.push(i, i + 1, i + SIDE + 2, i, i + SIDE + 2, i + SIDE + 1)
    }
  }
  return weldSurface({ positions, indices })
}

/** Flattens the patch from its projection, which shortens it at both sides. */
function flattened(): FlatChart {
  const surface = patch()
  const chart = flatChart(
    surface,
    () => true,
    (point) => [surface.points[3 * point], surface.points[3 * point + 1]],
  )
  if (!chart) throw new Error('the patch has no triangles')
  return chart
}

test('a chart of a cylinder keeps lengths within 1%', () => {
  const { surface, corners, points, flat } = flattened()
  for (let i = 0; i < corners.length; i++) {
    const [a, b] = [corners[i], corners[i % 3 === 2 ? i - 2 : i + 1]]
    const inSpace = Math.hypot(
      ...[0, 1, 2].map((k) => surface.points[3 * points[a] + k] - surface.points[3 * points[b] + k]),
    )
    const inPlane = Math.hypot(flat[2 * a] - flat[2 * b], flat[2 * a + 1] - flat[2 * b + 1])
    expect(Math.abs(inPlane / inSpace - 1)).toBeLessThan(0.01)
  }
})

test('positions of a chart are found on the surface, and none beyond it', () => {
  const chart = flattened()
  for (const [x, y] of [
    [0, 0],
    [-25, 20],
    [28, -28],
  ]) {
    const lifted = liftPoint(chart, 0, x, y)
    const [px, py, pz] = lifted!.point.position
    expect(RADIUS * Math.atan2(px, pz)).toBeCloseTo(x, 0)
    expect(py).toBeCloseTo(y, 0)
  }
  expect(liftPoint(chart, 0, 40, 0)).toBeUndefined()
})

test('compression around the cylinder is compression along x of the chart', () => {
  const chart = flattened()
  const { surface } = chart
  const tensors = new Float64Array((TENSOR_SIZE * surface.points.length) / 3)
  for (let point = 0; point < surface.points.length / 3; point++) {
    const [x, z] = [surface.points[3 * point] / RADIUS, surface.points[3 * point + 2] / RADIUS]
    // 0.2 t t for the tangent t = (z, 0, -x).
    tensors.set([0.2 * z * z, 0, -0.2 * x * z, 0, 0, 0.2 * x * x], TENSOR_SIZE * point)
  }
  const samples = sampleChart(chart, 2, 4)
  const [xx, xy, yy] = sampleTensors(samples, tensors)
  const inside = samples.triangles.reduce((count, triangle) => count + (triangle >= 0 ? 1 : 0), 0)
  expect(inside).toBeGreaterThan(0.9 * (60 / 2) ** 2)
  for (let i = 0; i < xx.length; i++) {
    if (samples.triangles[i] < 0) {
      expect([xx[i], xy[i], yy[i]]).toEqual([0, 0, 0])
      continue
    }
    expect(Math.abs(xx[i] - 0.2)).toBeLessThan(0.01)
    expect(Math.abs(xy[i])).toBeLessThan(0.01)
    expect(Math.abs(yy[i])).toBeLessThan(0.01)
  }
})

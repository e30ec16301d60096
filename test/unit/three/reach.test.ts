import { Vector4 } from 'three'
import { expect, it } from 'vitest'
import { findReach, reachAll } from '../../../packages/furrow/src/runtime/reach.ts'
import type { AreaArray } from '../../../packages/furrow/src/three/atlas/area-array.ts'

const slot = (x0: number, y0: number, x1: number, y1: number) => ({ bounds: { x0, y0, x1, y1 } })
const areas = {
  width: 16,
  height: 8,
  slots: [slot(2, 2, 4, 5), slot(8, 1, 10, 3), slot(0, 0, 16, 8), slot(3, 0, 5, 2)],
} as unknown as AreaArray

function reachOf(...values: number[]): number[] {
  const reach = new Vector4()
  findReach(areas, Float32Array.from(values), reach)
  return reach.toArray()
}

const contains = ([u0, v0, u1, v1]: number[], u: number, v: number) =>
  u >= u0 && u <= u1 && v >= v0 && v <= v1

it('the bounds of the active areas extend to the centres of the adjacent texels', () => {
  expect(reachOf(0.5, 0, 0, 0)).toEqual([1.5 / 16, 1.5 / 8, 4.5 / 16, 5.5 / 8])
  expect(reachOf(1, 0.1, 0, 0)).toEqual([1.5 / 16, 0.5 / 8, 10.5 / 16, 5.5 / 8])
})

it('the bounds have no limit where an active area is at an edge of the map, because textures are clamped there', () => {
  const whole = reachOf(0, 0, 1, 0)
  expect(contains(whole, -3, 7)).toBe(true)
  expect(contains(reachOf(0, 0, 0, 1), 0.2, -5)).toBe(true)
  expect(contains(reachOf(0, 0, 0, 1), 0.6, -5)).toBe(false)
  const reach = new Vector4()
  reachAll(reach)
  expect(contains(reach.toArray(), 100, -100)).toBe(true)
})

it('the bounds are empty if all areas are at rest', () => {
  for (const u of [-1, 0, 0.02, 0.5, 0.99, 1, 2]) expect(contains(reachOf(0, 0, 0, 0), u, 0.5)).toBe(false)
})

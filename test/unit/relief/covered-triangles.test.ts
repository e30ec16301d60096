import { expect, it } from 'vitest'
import { coveredTriangles } from '../../../packages/furrow/src/relief/covered-triangles.ts'
import {
  HeightField,
  raisedTexels,
  weightedTexels,
} from '../../../packages/furrow/src/relief/height-fields.ts'
import { finish } from './coarse.ts'

const SIDE = 16

/** Returns four triangles: tiny in texel (4, 4), over the whole texture, away from that texel, and in that texel of another UV tile. */
function triangles() {
  const at = (u: number, v: number, side: number) => [u, v, u + side, v, u, v + side]
  const uvs = [...at(0.28, 0.28, 0.001), ...at(0, 0, 0.9), ...at(0.6, 0.6, 0.2), ...at(-0.72, 2.28, 0.001)]
  return { positions: new Float32Array(36), uvs, triangles: Array.from({ length: 12 }, (_, i) => i) }
}

/** Returns an array of gray slices of one value. Texel (4, 4) of the last slice has another value. */
function images(depth: number, value: number, texel: number) {
  const data = new Uint8Array(depth * SIDE * SIDE).fill(value)
  data[(depth - 1) * SIDE * SIDE + 4 + 4 * SIDE] = texel
  return { width: SIDE, height: SIDE, depth, channels: 1 as const, data }
}

const LAYER = { slice: 0, amplitude: 0.002, areas: [0] }

it('a triangle is covered if an area has any weight on it, also if the triangle or the weight is tiny', () => {
  const areas = images(2, 0, 1)
  expect([...coveredTriangles(triangles(), weightedTexels(areas, [1]))]).toEqual([1, 1, 0, 1])
  expect([...coveredTriangles(triangles(), weightedTexels(areas, [0]))]).toEqual([0, 0, 0, 0])
})

it('texels count as raised if height times area weight exceeds the threshold', () => {
  const raised = (areas: ReturnType<typeof images> | null, metres: number) => {
    const field = new HeightField(LAYER, images(1, 128, 255), areas)
    return [...coveredTriangles(triangles(), finish(raisedTexels([field], metres)))]
  }
  expect(raised(null, 0.0001)).toEqual([1, 1, 0, 1])
  expect(raised(images(1, 255, 255), 0.0001)).toEqual([1, 1, 0, 1])
  expect(raised(images(1, 0, 0), 0.0001)).toEqual([0, 0, 0, 0])
  expect(raised(images(1, 100, 100), 0.0003)).toEqual([1, 1, 0, 1])
  expect(raised(images(1, 100, 100), 0.0005)).toEqual([0, 0, 0, 0])
})

it('the heights of layers add up', () => {
  const field = new HeightField(LAYER, images(1, 255, 255), null)
  expect(finish(raisedTexels([field], 0.0015)).data[0]).toBe(0)
  expect(finish(raisedTexels([field, field], 0.0015)).data[0]).toBe(1)
})

import { expect, it } from 'vitest'
import { HeightField } from '../../../packages/furrow/src/relief/height-fields.ts'
import { neededHalvings, TOLERANCES } from '../../../packages/furrow/src/relief/needed-halvings.ts'

const SIDE = 64

/** Halvings of two triangles, 16 texels wide, on the left and on the right of the texture. */
function halvings(
  heightAt: (x: number, y: number) => number,
  amplitude = 0.001,
  layers = 1,
  normals: ArrayLike<number> = new Float32Array(18),
  { mipmap = 0, version = 0 } = {},
): number[] {
  const at = (u: number) => [u, 0.25, u + 0.25, 0.25, u, 0.5]
  const mesh = {
    positions: [0, 0, 0, 0.01, 0, 0, 0, 0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0.01, 0],
    uvs: [...at(0.125), ...at(0.625)],
    triangles: [0, 1, 2, 3, 4, 5],
  }
  const data = Uint8Array.from({ length: SIDE * SIDE }, (_, i) => heightAt(i % SIDE, Math.floor(i / SIDE)))
  const heights = { width: SIDE, height: SIDE, depth: 1, channels: 1 as const, data }
  const field = new HeightField({ slice: 0, amplitude, areas: [] }, heights, null)
  return [
    ...neededHalvings(mesh, normals, Array(layers).fill(field), new Float32Array(6).fill(mipmap))[version],
  ]
}

const narrow = (x: number) => (x === 15 ? 0 : 128)
const broad = (x: number) => 128 + 127 * Math.sin((x / SIDE) * 2 * Math.PI)

it('skin without heights is not split, nor is skin that heights lift evenly', () => {
  expect(halvings(() => 128)).toEqual([0, 0])
  expect(halvings(() => 255)).toEqual([0, 0])
  expect(halvings((x, y) => 40 + 2 * x + y)).toEqual([0, 0])
})

it('a narrow valley takes more halvings than a broad bulge, and only where it is', () => {
  const [valley, beside] = halvings(narrow)
  expect(beside).toBe(0)
  expect(valley).toBeGreaterThan(2)
  const [bulge] = halvings(broad)
  expect(bulge).toBeGreaterThan(0)
  expect(bulge).toBeLessThan(valley)
})

it('a triangle that is curved between its corners is split where heights move it', () => {
  const turned = Float32Array.from({ length: 18 }, (_, i) => (i % 9 === 3 ? 0.2 : Number(i % 3 === 2)))
  expect(halvings(() => 255, 0.001, 1, turned)).toEqual([2, 2])
  expect(halvings(() => 128, 0.001, 1, turned)).toEqual([0, 0])
})

it('a coarser version takes fewer halvings, and so does a valley that is narrower than mipmaps show', () => {
  const rough = (version: number) => halvings(broad, 0.001, 1, undefined, { version })[0]
  const versions = TOLERANCES.map((_, version) => rough(version))
  expect(versions[0]).toBeGreaterThan(versions[2])
  expect(versions).toEqual([...versions].sort((a, b) => b - a))
  expect(halvings(narrow, 0.0005, 1, undefined, { mipmap: 2 })[0]).toBeLessThan(halvings(narrow, 0.0005)[0])
})

it('a valley that nobody sees takes none, unless layers have it together', () => {
  expect(halvings(narrow, 1.5 * TOLERANCES[0])).toEqual([0, 0])
  expect(halvings(narrow, 1.5 * TOLERANCES[0], 2)[0]).toBeGreaterThan(0)
})

it('heights of a single texel, and triangles without area or with coordinates that are no numbers, need none', () => {
  const texel = {
    width: 1,
    height: 1,
    depth: 1,
    channels: 1 as const,
    data: new Uint8Array([255]),
  }
  const field = new HeightField({ slice: 0, amplitude: 0.003, areas: [] }, texel, null)
  const mesh = {
    positions: new Float32Array(18),
    uvs: [0, 0, 0.5, 0, 1, 0, 0, 0, 7, Number.NaN, 1, 1],
    triangles: [0, 0, 0, 0, 1, 2, 3, 4, 5],
  }
  expect(neededHalvings(mesh, mesh.positions, [field], new Float32Array(6))[0]).toEqual(new Uint8Array(3))
})

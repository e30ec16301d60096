import { expect, it } from 'vitest'
import { Rng } from '../../../packages/furrow/src/math/rng.ts'
import { HeightField } from '../../../packages/furrow/src/relief/height-fields.ts'
import { neededHalvings, TOLERANCES } from '../../../packages/furrow/src/relief/needed-halvings.ts'
import { splitMesh } from '../../../packages/furrow/src/relief/split-mesh.ts'
import { finish } from './coarse.ts'

const SIDE = 64

/** Returns, for each of two triangles, the halvings of the edge that is halved most. One triangle is on the left of the texture, one on the right. */
function halvings(...args: Parameters<typeof ofEdges>): number[] {
  const [a, b, c, d, e, f] = ofEdges(...args)
  return [Math.ceil(Math.max(a, b, c, 0)), Math.ceil(Math.max(d, e, f, 0))]
}

/** Returns how often each edge of the two triangles must be halved, in order: horizontal, diagonal, vertical. */
function ofEdges(
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
    ...finish(neededHalvings(mesh, normals, Array(layers).fill(field), new Float32Array(6).fill(mipmap)))[
      version
    ],
  ]
}

const narrow = (x: number) => (x === 15 ? 0 : 128)
const broad = (x: number) => 128 + 127 * Math.sin((x / SIDE) * 2 * Math.PI)

it('skin without heights is not split, and neither is evenly raised skin', () => {
  expect(halvings(() => 128)).toEqual([0, 0])
  expect(halvings(() => 255)).toEqual([0, 0])
  expect(halvings((x, y) => 40 + 2 * x + y)).toEqual([0, 0])
})

it('a narrow valley needs more halvings than a broad bulge, and none beside it', () => {
  const [valley, beside] = halvings(narrow)
  expect(beside).toBe(0)
  expect(valley).toBeGreaterThan(2)
  const [bulge] = halvings(broad)
  expect(bulge).toBeGreaterThan(0)
  expect(bulge).toBeLessThan(valley)
})

it('edges across a valley are split, and edges along it are not', () => {
  const [alongRow, slanted, downColumn] = ofEdges(broad)
  expect(downColumn).toBeLessThan(-1)
  expect(Math.abs(slanted - alongRow)).toBeLessThan(0.2)
  expect(alongRow).toBeGreaterThan(0)
  expect(ofEdges((_, y) => broad(y))[0]).toBeLessThan(-1)
})

it.each([0, 0.4, 1.1, 2])(
  'a surface that is split as needed follows waves in direction %f within about the tolerance',
  (turn) => {
    const [along, across] = [Math.cos(turn), Math.sin(turn)]
    const data = Uint8Array.from({ length: SIDE * SIDE }, (_, i) => {
      const [x, y] = [i % SIDE, Math.floor(i / SIDE)]
      return 127.5 + 127.5 * Math.sin((x * along + y * across) / 5)
    })
    const heights = { width: SIDE, height: SIDE, depth: 1, channels: 1 as const, data }
    const field = new HeightField({ slice: 0, amplitude: 0.002, areas: [] }, heights, null)
    const mesh = {
      positions: [0, 0, 0, 0.04, 0, 0, 0.004, 0.03, 0, 0.044, 0.034, 0],
      uvs: [0.1, 0.1, 0.9, 0.1, 0.15, 0.8, 0.95, 0.9],
      triangles: [0, 1, 2, 2, 1, 3],
    }
    const flat = new Float32Array(12)
    const needed = finish(neededHalvings(mesh, flat, [field], new Float32Array(4)))
    const heightAt = (u: number, v: number) => field.between(u * SIDE - 0.5, v * SIDE - 0.5)
    const counts = TOLERANCES.map((tolerance, version) => {
      const { triangles, uvs } = finish(splitMesh(mesh, needed[version], { edge: 1e-5 }))
      let worst = 0
      for (let k = 0; k < triangles.length; k += 3) {
        const corners = [0, 1, 2].map((i) => [
          ...uvs.subarray(4 * triangles[k + i], 4 * triangles[k + i] + 2),
        ])
        for (const weights of [
          [0.5, 0.5, 0],
          [0, 0.5, 0.5],
          [0.5, 0, 0.5],
          [1 / 3, 1 / 3, 1 / 3],
        ]) {
          const mix = (values: number[]) => values.reduce((sum, value, i) => sum + value * weights[i], 0)
          const plane = mix(corners.map(([u, v]) => heightAt(u, v)))
          worst = Math.max(
            worst,
            Math.abs(plane - heightAt(mix(corners.map(([u]) => u)), mix(corners.map(([, v]) => v)))),
          )
        }
      }
      expect(worst).toBeLessThan(1.15 * tolerance)
      return triangles.length / 3
    })
    expect(counts[0]).toBeGreaterThan(counts[2])
  },
)

it('no edge has more parts than the other two together, and a finer version has at least as many parts as a coarser one', () => {
  for (let seed = 1; seed <= 50; seed++) {
    const rng = new Rng(seed)
    const bytes = Array.from({ length: SIDE * SIDE }, () => rng.next() * 255)
    const amplitude = 0.001 * rng.next()
    const versions = TOLERANCES.map((_, version) => {
      const rough = (x: number, y: number) => bytes[x + y * SIDE]
      return ofEdges(rough, amplitude, 1, undefined, { version }).slice(0, 3)
    })
    for (const [i, version] of versions.entries()) {
      const [a, b, c] = version.map((halvings) => 2 ** halvings)
      expect(2 * Math.max(a, b, c)).toBeLessThan(1.0001 * (a + b + c))
      for (const [k, halvings] of version.entries())
        expect(halvings).toBeLessThanOrEqual(versions[i - 1]?.[k] ?? halvings)
    }
  }
})

it('area weights are interpolated between texels, so that borders of areas are no steps', () => {
  const data = new Uint8Array(SIDE * SIDE).fill(255)
  const heights = { width: SIDE, height: SIDE, depth: 1, channels: 1 as const, data }
  const areas = { width: 4, height: 1, depth: 1, channels: 1 as const, data: new Uint8Array([0, 255, 0, 0]) }
  const field = new HeightField({ slice: 0, amplitude: 0.002, areas: [0] }, heights, areas)
  // The area's texel with weight covers the height texels from 16 on. Its centre is at 23.5.
  expect(field.between(23.5, 8)).toBeCloseTo(0.001, 9)
  expect(field.between(15.5, 8)).toBeCloseTo(0.0005, 9)
  expect(field.between(7.5, 8)).toBe(0)
})

it('a triangle with different normals at its corners is split if heights move it', () => {
  const turned = Float32Array.from({ length: 18 }, (_, i) => (i % 9 === 3 ? 0.2 : Number(i % 3 === 2)))
  expect(halvings(() => 255, 0.001, 1, turned)).toEqual([2, 2])
  expect(halvings(() => 128, 0.001, 1, turned)).toEqual([0, 0])
})

it('a coarser version needs fewer halvings, and so does a narrow valley at a coarse mipmap level', () => {
  const rough = (version: number) => halvings(broad, 0.001, 1, undefined, { version })[0]
  const versions = TOLERANCES.map((_, version) => rough(version))
  expect(versions[0]).toBeGreaterThan(versions[2])
  expect(versions).toEqual([...versions].sort((a, b) => b - a))
  expect(halvings(narrow, 0.0005, 1, undefined, { mipmap: 2 })[0]).toBeLessThan(halvings(narrow, 0.0005)[0])
})

it('a valley below the tolerance needs none, unless several layers add up', () => {
  expect(halvings(narrow, 1.4 * TOLERANCES[0])).toEqual([0, 0])
  expect(halvings(narrow, 1.4 * TOLERANCES[0], 2)[0]).toBeGreaterThan(0)
})

it('height maps of one texel, and triangles without area or with NaN coordinates, need no halvings', () => {
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
  const [needed] = finish(neededHalvings(mesh, mesh.positions, [field], new Float32Array(6)))
  expect(Math.max(...needed)).toBe(0)
})

import { expect, it } from 'vitest'
import type { CoarseMesh } from '../../../packages/furrow/src/relief/coarse-mesh.ts'
import { coveredTriangles } from '../../../packages/furrow/src/relief/covered-triangles.ts'
import type { DenseMesh } from '../../../packages/furrow/src/relief/dense-mesh.ts'
import { displace, displacement } from '../../../packages/furrow/src/relief/displaced.ts'
import { splitMesh } from '../../../packages/furrow/src/relief/split-mesh.ts'
import { MAX_LEVEL } from '../../../packages/furrow/src/relief/welded-edges.ts'
import { finish, sphere } from './coarse.ts'

const RADIUS = 0.05
const EDGE = 0.003

/** Returns 1 for each triangle whose centre meets a condition, otherwise 0. */
function cover(mesh: CoarseMesh, isCovered: (x: number, y: number, z: number) => boolean): Float32Array {
  return Float32Array.from(mesh.triangles, (_, corner) => {
    const t = Math.floor(corner / 3)
    const [x, y, z] = [0, 1, 2].map((axis) =>
      [0, 1, 2].reduce((sum, k) => sum + mesh.positions[3 * mesh.triangles[3 * t + k] + axis] / 3, 0),
    )
    return isCovered(x, y, z) ? MAX_LEVEL : 0
  })
}

const half = (mesh: CoarseMesh) => cover(mesh, (x, y) => x + y > 0.01)

function positionsOf(mesh: CoarseMesh, dense: DenseMesh): Float64Array {
  const out = new Float64Array(3 * dense.count)
  for (let i = 0; i < out.length; i++) {
    const [vertex, axis] = [Math.floor(i / 3), i % 3]
    for (let k = 0; k < 3; k++) {
      out[i] += dense.weights[3 * vertex + k] * mesh.positions[3 * dense.corners[3 * vertex + k] + axis]
    }
  }
  return out
}

/** Returns the number of triangles at each edge. Vertices at one position count as one. */
function edgeCounts(positions: Float64Array, triangles: Uint32Array): number[] {
  const names = Array.from({ length: positions.length / 3 }, (_, i) =>
    positions.subarray(3 * i, 3 * i + 3).join(),
  )
  const counts = new Map<string, number>()
  for (let k = 0; k < triangles.length; k += 3) {
    const corners = [0, 1, 2].map((i) => names[triangles[k + i]])
    // Skips triangles at the poles of the sphere, which have no area.
    if (new Set(corners).size < 3) continue
    for (const [i, name] of corners.entries()) {
      const edge = [name, corners[(i + 1) % 3]].sort().join(' ')
      counts.set(edge, (counts.get(edge) ?? 0) + 1)
    }
  }
  return [...counts.values()]
}

it('a closed surface stays closed: split triangles and their neighbours meet without T-junctions, also at seams', () => {
  const mesh = sphere(RADIUS)
  const dense = finish(splitMesh(mesh, half(mesh), { edge: EDGE }))
  expect(dense.triangles.length).toBeGreaterThan(3 * mesh.triangles.length)
  expect(new Set(edgeCounts(positionsOf(mesh, dense), dense.triangles))).toEqual(new Set([2]))
})

it('coarser versions are closed too, and add less than 5% to the vertices of the finest version', () => {
  const mesh = sphere(RADIUS)
  const finest = half(mesh).map((most, corner) => Math.min(most, 1 + (Math.floor(corner / 3) % 4)))
  const coarser = [1, 2, 9].map((less) => finest.map((halvings) => Math.max(halvings - less, 0)))
  const dense = finish(splitMesh(mesh, finest, { edge: EDGE / 2, coarser }))
  const alone = finish(splitMesh(mesh, finest, { edge: EDGE / 2 }))
  expect(dense.triangles.length).toBe(alone.triangles.length)
  expect(dense.count).toBeLessThan(1.05 * alone.count)
  const positions = positionsOf(mesh, dense)
  const versions = [dense.triangles, ...dense.coarser]
  for (const triangles of versions) expect(new Set(edgeCounts(positions, triangles))).toEqual(new Set([2]))
  const lengths = versions.map(({ length }) => length)
  expect(lengths).toEqual([...new Set(lengths)].sort((a, b) => b - a))
  expect(dense.coarser[2]).toEqual(Uint32Array.from(mesh.triangles))
})

it('edges of covered triangles have the requested length, and others are not split', () => {
  const mesh = sphere(RADIUS)
  const covered = half(mesh)
  const dense = finish(splitMesh(mesh, covered, { edge: EDGE }))
  expect(dense.edge).toBe(EDGE)
  const positions = positionsOf(mesh, dense)
  for (let k = 0; k < dense.triangles.length; k += 3) {
    const [a, b, c] = dense.triangles.subarray(k, k + 3)
    const x = (positions[3 * a] + positions[3 * b] + positions[3 * c]) / 3
    const y = (positions[3 * a + 1] + positions[3 * b + 1] + positions[3 * c + 1]) / 3
    const lengths = [
      [a, b],
      [b, c],
      [c, a],
    ].map(([p, q]) => Math.hypot(...[0, 1, 2].map((i) => positions[3 * p + i] - positions[3 * q + i])))
    if (x + y > 0.04) expect(Math.max(...lengths)).toBeLessThan(1.42 * EDGE)
    if (x + y < -0.03) expect(Math.max(a, b, c)).toBeLessThan(mesh.positions.length / 3)
  }
})

it('triangles keep their orientation and total area', () => {
  const mesh = sphere(RADIUS)
  const dense = finish(splitMesh(mesh, half(mesh), { edge: EDGE }))
  const area = (positions: ArrayLike<number>, triangles: ArrayLike<number>) => {
    let sum = 0
    for (let k = 0; k < triangles.length; k += 3) {
      const at = (corner: number, axis: number) => positions[3 * triangles[k + corner] + axis]
      const u = [0, 1, 2].map((axis) => at(1, axis) - at(0, axis))
      const v = [0, 1, 2].map((axis) => at(2, axis) - at(0, axis))
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
      expect(normal[0] * at(0, 0) + normal[1] * at(0, 1) + normal[2] * at(0, 2)).toBeGreaterThan(-1e-9)
      sum += Math.hypot(...normal) / 2
    }
    return sum
  }
  expect(area(positionsOf(mesh, dense), dense.triangles)).toBeCloseTo(area(mesh.positions, mesh.triangles), 8)
})

it('displaced vertices at a seam are equal bit for bit, although their heights differ', () => {
  const mesh = sphere(RADIUS)
  const dense = finish(splitMesh(mesh, half(mesh), { edge: EDGE }))
  const clearance = new Float32Array(mesh.positions.length / 3).fill(1)
  const heightAt = (u: number, v: number) => 0.001 * Math.sin(20 * u) * Math.cos(9 * v)
  const out = displace(dense, mesh, heightAt, clearance)
  expect(new Set(edgeCounts(out, dense.triangles))).toEqual(new Set([2]))
})

it('Phong tessellation rounds a sphere, heights move it outwards, and an amount of 0 changes nothing', () => {
  const mesh = sphere(RADIUS)
  const dense = finish(
    splitMesh(
      mesh,
      cover(mesh, () => true),
      { edge: EDGE },
    ),
  )
  const clearance = new Float32Array(mesh.positions.length / 3).fill(1)
  const farthestFrom = (radius: number, positions: Float64Array) => {
    let worst = 0
    for (let i = 0; i < positions.length; i += 3) {
      worst = Math.max(worst, Math.abs(Math.hypot(positions[i], positions[i + 1], positions[i + 2]) - radius))
    }
    return worst
  }
  const flat = farthestFrom(RADIUS, positionsOf(mesh, dense))
  expect(
    farthestFrom(
      RADIUS,
      displace(dense, mesh, () => 0, clearance),
    ),
  ).toBeLessThan(flat / 10)
  const raised = displace(dense, mesh, () => 0.002, clearance)
  expect(farthestFrom(RADIUS + 0.002, raised)).toBeLessThan(flat / 10)
  const none = displace(dense, mesh, () => 0.002, clearance, 0)
  const asTheyAre = positionsOf(mesh, dense)
  expect(Math.max(...none.map((value, i) => Math.abs(value - asTheyAre[i])))).toBeLessThan(1e-15)
  const narrow = displace(dense, mesh, () => 0.002, clearance.fill(0.001))
  expect(farthestFrom(RADIUS + 0.001, narrow)).toBeLessThan(flat / 10)
})

it('displacement adds up the active layers, and middle gray is no displacement', () => {
  const layers = [
    { influence: 0.5, height: 1, amplitude: 0.002 },
    { influence: 1, height: 0.25, amplitude: 0.001 },
    { influence: 1, height: 0.5, amplitude: 1 },
    { influence: 0, height: 0, amplitude: 1 },
  ]
  expect(displacement(layers)).toBeCloseTo(0.0005 - 0.00025, 12)
})

it('longer edges keep a mesh within its budget of triangles', () => {
  const mesh = sphere(RADIUS, 24)
  const all = cover(mesh, () => true)
  const dense = finish(splitMesh(mesh, all, { edge: 0.0005, budget: 5000 }))
  expect(dense.triangles.length / 3).toBeLessThan(2 * 5000)
  expect(dense.edge).toBeGreaterThan(0.0005)
  const whole = finish(splitMesh(mesh, all, { edge: 0.0005, budget: 10 }))
  expect(whole.triangles).toEqual(Uint32Array.from(mesh.triangles))
})

it('triangles without area or with NaN coordinates are kept unchanged', () => {
  const mesh = {
    positions: [0, 0, 0, 0.01, 0, 0, 0.02, 0, 0, Number.NaN, 0, 0],
    uvs: [0, 0, 0.5, 0, 1, 0, 0, Number.NaN],
    triangles: [0, 0, 0, 0, 1, 2, 0, 1, 3],
  }
  const dense = finish(splitMesh(mesh, new Float32Array(9).fill(MAX_LEVEL), { edge: 0.001 }))
  expect(dense.triangles.length).toBeGreaterThan(9)
  expect(dense.weights.every(Number.isFinite)).toBe(true)
  const everywhere = { width: 2, height: 2, data: new Uint8Array(4).fill(1) }
  expect(coveredTriangles(mesh, everywhere)).toEqual(new Uint8Array([1, 1, 0]))
})

it('the work is divided into steps', () => {
  const mesh = sphere(RADIUS, 64)
  let slices = 0
  const steps = splitMesh(mesh, half(mesh), { edge: EDGE })
  while (!steps.next().done) slices++
  expect(slices).toBeGreaterThan(20)
})

it('a triangle that is split in one direction becomes strips, and leaves no gap to its neighbours', () => {
  const mesh = sphere(RADIUS)
  const strips = Float32Array.from(mesh.triangles, (_, corner) => [-2, 2.7, 2.7][corner % 3])
  const dense = finish(splitMesh(mesh, strips, { edge: 1e-4 }))
  expect(new Set(edgeCounts(positionsOf(mesh, dense), dense.triangles))).toEqual(new Set([2]))
  const alone = {
    positions: [0, 0, 0, 0.01, 0, 0, 0, 0.01, 0],
    uvs: [0, 0, 1, 0, 0, 1],
    triangles: [0, 1, 2],
  }
  const counts = [0, 0.7, 1.7, 2.7].map((halvings) => {
    const { triangles } = finish(splitMesh(alone, new Float32Array([-2, halvings, halvings]), { edge: 1e-4 }))
    return triangles.length / 3
  })
  expect(counts).toEqual([1, 3, 9, 27])
})

it('edges are halved no more often than their triangles need', () => {
  const mesh = sphere(RADIUS)
  const halved = (halvings: number) =>
    finish(
      splitMesh(
        mesh,
        half(mesh).map((most) => Math.min(most, halvings)),
        { edge: EDGE },
      ),
    ).triangles.length
  const [none, once, twice] = [0, 1, 2].map(halved)
  expect(none).toBe(mesh.triangles.length)
  expect(once).toBeGreaterThan(1.5 * none)
  expect(twice).toBeGreaterThan(1.5 * once)
  const dense = finish(
    splitMesh(
      mesh,
      half(mesh).map((_, corner) => Math.floor(corner / 3) % 4),
      { edge: EDGE },
    ),
  )
  expect(new Set(edgeCounts(positionsOf(mesh, dense), dense.triangles))).toEqual(new Set([2]))
})

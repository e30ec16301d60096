import { expect, it } from 'vitest'
import { outwardClearance } from '../../../packages/furrow/src/relief/outward-clearance.ts'
import { firstVertices } from '../../../packages/furrow/src/relief/welded-edges.ts'
import { finish, sphere } from './coarse.ts'

/** Makes a sheet of 20 x 20 squares, each 1 mm wide, at the height `y`. `up` is 1 if it faces up, -1 if it faces down. */
function sheet(y: number, up: 1 | -1) {
  const positions: number[] = []
  const normals: number[] = []
  const triangles: number[] = []
  for (let i = 0; i <= 20; i++) {
    for (let j = 0; j <= 20; j++) {
      positions.push(i / 1000, y, j / 1000)
      normals.push(0, up, 0)
      if (i === 20 || j === 20) continue
      const a = i * 21 + j
      triangles.push(...(up === 1 ? [a, a + 1, a + 21] : [a, a + 21, a + 1]))
      triangles.push(...(up === 1 ? [a + 1, a + 22, a + 21] : [a + 1, a + 21, a + 22]))
    }
  }
  return { positions, normals, triangles }
}

const CENTRE = 10 * 21 + 10
const REACH = 0.001

it('each of two facing surfaces may rise by less than half of the gap, and surfaces that face away by the full reach', () => {
  const roomBetween = (gap: number, facing: 1 | -1) => {
    const [lower, upper] = [sheet(0, facing), sheet(gap, -facing as 1 | -1)]
    const mesh = {
      positions: [...lower.positions, ...upper.positions],
      uvs: new Float32Array(2 * 882),
      triangles: [...lower.triangles, ...upper.triangles.map((i) => i + 441)],
    }
    const firstOf = firstVertices(mesh.positions)
    return finish(outwardClearance(mesh, [...lower.normals, ...upper.normals], firstOf, REACH))
  }
  const lips = roomBetween(0.001, 1)
  expect(lips[CENTRE]).toBeCloseTo(0.0004, 6)
  expect(lips[CENTRE + 441]).toBeCloseTo(0.0004, 6)
  expect(roomBetween(0.001, -1)[CENTRE]).toBeGreaterThan(2 * REACH)
})

it('the allowed height is 0 at the border of a mesh, and increases with the distance from it', () => {
  const mesh = { ...sheet(0, 1), uvs: new Float32Array(882) }
  const firstOf = firstVertices(mesh.positions)
  const clearance = finish(outwardClearance(mesh, mesh.normals, firstOf, REACH))
  expect(clearance[0]).toBe(0)
  expect(clearance[2 * 21 + 10]).toBeCloseTo(0.0005, 6)
  expect(clearance[CENTRE]).toBeGreaterThan(REACH)
})

it('a sphere may rise by the full reach everywhere', () => {
  const mesh = sphere(0.05, 32)
  const firstOf = firstVertices(mesh.positions)
  expect(Math.min(...finish(outwardClearance(mesh, mesh.normals, firstOf, REACH)))).toBeGreaterThan(REACH)
})

it('the work can be spread over frames', () => {
  const mesh = sphere(0.05, 48)
  const steps = [...outwardClearance(mesh, mesh.normals, firstVertices(mesh.positions), REACH)]
  expect(steps.length).toBeGreaterThan(4)
})

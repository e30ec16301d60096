import { expect, test } from 'vitest'
import { jointPosesOf, type PosedSurface } from '../../../packages/cli/src/auto/report/joint-poses.ts'

const bind = (x: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1]
const FULL = 1

/** Returns a square of cloth in the plane of x and y, which faces +Z. One area covers it, driven by the joints from `a` to `c`. */
function square(name: string, side: number, curve: [number, number][]): PosedSurface {
  const corners = [0, 0, 1, 0, 1, 1, 0, 1]
  return {
    found: {
      meshName: `mesh of ${name}`,
      skin: {
        positions: [0, 1, 2, 3].flatMap((i) => [side * corners[2 * i]!, side * corners[2 * i + 1]!, 0]),
        uvs: corners,
        indices: [0, 1, 2, 0, 2, 3],
        targets: [],
        skeleton: {
          joints: ['a', 'b', 'c'].map((joint, i) => ({ name: joint, parent: i - 1, bind: bind(i) })),
          influences: 1,
          indices: [0, 1, 2, 2],
          weights: [1, 1, 1, 1],
        },
      },
    },
    wrinkles: {
      jointAreas: [
        {
          name,
          layer: 0,
          weights: { width: 2, height: 2, data: new Uint8Array(4).fill(255) },
          drivers: [
            { type: 'bone', area: name, joints: ['a', 'c'], measure: 'angle', axis: [0, 0, 1], curve },
          ],
          compression: 0.2,
          error: 0,
          lines: 1,
        },
      ],
    },
  }
}

test('all joints between those of a driver share its angle, about its axis', () => {
  const [{ joints, joint, degrees, view, mesh }] = jointPosesOf([
    square('folds', 1, [
      [0, 0],
      [FULL, 1],
    ]),
  ]) as [ReturnType<typeof jointPosesOf>[number]]
  expect(Object.keys(joints)).toEqual(['b', 'c'])
  const angles = Object.values(joints).map(([x, y, z, w]) => [x, y, 2 * Math.atan2(z, w)])
  for (const [x, y, angle] of angles) {
    expect([x, y]).toEqual([0, 0])
    expect(angle).toBeCloseTo((0.7 * FULL) / 2)
  }
  expect([joint, degrees, mesh]).toEqual(['c', 40, 'mesh of folds'])
  expect(view.point.map((value) => Number(value.toFixed(6)))).toEqual([0.5, 0.5, 0])
  expect(view.pitch).toBeCloseTo(0)
})

test('the largest areas come first, and those that bending smooths are left out', () => {
  const sides = [0.1, 0.3, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]
  const folds = sides.map((side) =>
    square(`side ${side}`, side, [
      [0, 0],
      [FULL, 1],
    ]),
  )
  const smoothed = square('smoothed', 2, [
    [0, 1],
    [FULL, 0],
  ])
  const names = jointPosesOf([smoothed, ...folds]).map(({ name }) => name)
  expect(names).toEqual([0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2].map((side) => `side ${side}`))
})

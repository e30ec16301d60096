import { autoWrinkles } from 'furrow/author'
import { expect, it } from 'vitest'
import { activationsOf, shippedSkin } from './models.ts'

const skin = await shippedSkin('neck')
const neck = autoWrinkles(skin, { size: 64, areaSize: 32 })
const activations = activationsOf(skin, neck)
const CHAIN = ['neck01', 'neck02', 'neck03', 'head']

/** Turns the head by an angle in radians about an axis of the neck's joints: x to the left, y up, z to the front. */
function turned(axis: readonly [number, number, number], angle: number): string[] {
  const found = activations(CHAIN.map((joint) => [joint, axis, angle / CHAIN.length]))
  return Object.entries(found)
    .filter(([, activation]) => activation > 0.6)
    .map(([area]) => area)
}

it('a neck creases in six directions', () => {
  expect(neck.jointAreas.map(({ name }) => name)).toEqual([
    'head forward',
    'head back',
    'head turn to the left',
    'head turn to the right',
    'head tilt to the left',
    'head tilt to the right',
  ])
  for (const { name, lines, error, compression } of neck.jointAreas) {
    expect(lines, name).toBeGreaterThan(2)
    expect(error, name).toBeLessThan(0.1)
    expect(compression, name).toBeGreaterThan(0.1)
  }
})

it.each([
  ['forward', [1, 0, 0]],
  ['back', [-1, 0, 0]],
  ['turn to the left', [0, 1, 0]],
  ['turn to the right', [0, -1, 0]],
  ['tilt to the left', [0, 0, -1]],
  ['tilt to the right', [0, 0, 1]],
] as const)('a head that moves %s creases only the skin of this direction', (name, axis) => {
  expect(turned(axis, 0.6)).toEqual([`head ${name}`])
})

it('a neck has a few lines at rest, in front', () => {
  const { 'head forward': forward, ...others } = activations([])
  expect(forward).toBeCloseTo(0.22)
  for (const activation of Object.values(others)) expect(activation).toBeCloseTo(0)
})

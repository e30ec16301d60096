import { type AutoWrinkles, autoWrinkles, type Skin } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { activationsOf } from './models.ts'
import { torso } from './torso.ts'

const SETTINGS = { size: 256, areaSize: 64, cloth: 'shirt' } as const
const DEGREE = Math.PI / 180
const CHAIN = ['mixamorig:Spine', 'mixamorig:Spine2']
const skin = torso()
const made = autoWrinkles(skin, SETTINGS)

/** Direction of the trunk, axis to the left, up or to the front, full angle in degrees, and where its folds lie in the texture. */
const DIRECTIONS = [
  ['forward', [1, 0, 0], 60, 0.5],
  ['tilt to the left', [0, 0, -1], 35, 0.25],
  ['tilt to the right', [0, 0, 1], 35, 0.75],
  ['turn to the left', [0, 1, 0], 45, undefined],
  ['turn to the right', [0, -1, 0], 45, undefined],
] as const

it('the cloth of a trunk folds in five directions', () => {
  expect(made.jointAreas.map(({ name }) => name)).toEqual(
    DIRECTIONS.map(([name]) => `mixamorig:Spine2 ${name}`),
  )
  for (const { name, lines, error, compression } of made.jointAreas) {
    expect(lines, name).toBeGreaterThan(3)
    expect(error, name).toBeLessThan(0.3)
    expect(compression, name).toBeGreaterThan(0.08)
  }
})

describe.each(DIRECTIONS)('a trunk that moves %s', (name, axis, full) => {
  const area = `mixamorig:Spine2 ${name}`
  const activations = activationsOf(skin, made)
  const at = (degrees: number) =>
    activations(CHAIN.map((joint) => [joint, axis, (degrees * DEGREE) / CHAIN.length]))

  it('folds only the cloth of this direction, after some slack', () => {
    expect(at(full)[area]).toBeCloseTo(1, 2)
    expect(at(0.12 * full)[area]).toBe(0)
    const others = Object.entries(at(full)).filter(([other]) => other !== area)
    for (const [other, activation] of others) expect(activation, other).toBeCloseTo(0, 5)
  })

  it('changes smoothly', () => {
    let before = 0
    for (let step = 1; step <= 200; step++) {
      const now = at((full * step) / 200)[area]!
      expect(Math.abs(now - before)).toBeLessThan(0.03)
      before = now
    }
  })
})

it.each(DIRECTIONS.slice(0, 3))(
  'a trunk that moves %s has its folds on the side that it compresses',
  (name, _, __, middle) => {
    const { width, height, data } = made.jointAreas.find((area) => area.name.endsWith(name))!.weights
    const covered = (u: number) => {
      const column = Math.round(u * width)
      const weights = Array.from({ length: height }, (_, y) => data[y * width + column]!)
      return weights.filter((weight) => weight > 0.5).length
    }
    expect(covered(middle!)).toBeGreaterThan(10)
    expect(covered((middle! + 0.5) % 1)).toBe(0)
  },
)

it('twisted cloth folds along diagonals, which lean to the other side if it twists to the other side', () => {
  const [left, right] = ['left', 'right'].map((side) => leanOf(made, `mixamorig:Spine2 turn to the ${side}`))
  expect(Math.abs(left!)).toBeGreaterThan(0.4)
  expect(Math.abs(right!)).toBeGreaterThan(0.4)
  expect(Math.sign(left!)).toBe(-Math.sign(right!))
})

it.each([
  ['whose joints have arbitrary axes', { turned: true }],
  ['in centimetres', { scale: 100 }],
  ['with meaningless names', { rename: (_: string, i: number) => `node${(7 * i) % 97}` }],
] as const)('a skeleton %s folds the trunk as often', (_, options) => {
  const other = autoWrinkles(torso(options) as Skin, { ...SETTINGS, seed: 1 })
  expect(other.jointAreas).toHaveLength(DIRECTIONS.length)
})

/** Returns the mean sine of twice the angle between the folds of an area and the horizontal: 1 for diagonals that rise to the right. */
function leanOf({ layers, jointAreas }: AutoWrinkles, name: string): number {
  const { layer } = jointAreas.find((area) => area.name === name)!
  let [sum, total] = [0, 0]
  for (const { points } of layers[layer]!.strokes) {
    for (let i = 1; i < points.length; i++) {
      // The shirt is 0.9 m around and 0.38 m tall.
      const dx = 0.9 * (points[i]![0]! - points[i - 1]![0]!)
      const dy = 0.38 * (points[i]![1]! - points[i - 1]![1]!)
      const square = dx * dx + dy * dy
      if (!(square > 0)) continue
      sum += (2 * dx * dy) / Math.sqrt(square)
      total += Math.sqrt(square)
    }
  }
  return sum / total
}

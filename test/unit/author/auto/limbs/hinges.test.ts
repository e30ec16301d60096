import { autoWrinkles } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { activationsOf } from './models.ts'
import { bothSleeves, sleeve } from './sleeve.ts'

const SETTINGS = { size: 512, areaSize: 64 } as const
const DEGREE = Math.PI / 180
/** Angle at which creases are complete. */
const FULL = 115
const LIMBS = [
  ['an elbow', ['LeftArm', 'LeftForeArm', 'LeftHand'], 0.25],
  // A knee flexes backwards.
  ['a knee', ['LeftUpLeg', 'LeftLeg', 'LeftFoot'], 0.75],
] as const

describe.each(LIMBS)('bare skin of %s', (_, joints, crook) => {
  const skin = sleeve({ joints })
  const made = autoWrinkles(skin, SETTINGS)
  const activations = activationsOf(skin, made)
  const [flexion, extension] = made.jointAreas.map(({ name }) => name) as [string, string]
  const { axis } = made.jointAreas[0]!.drivers[0]!
  const at = (degrees: number) => activations([[joints[1], axis!, degrees * DEGREE]])

  it('creases in the crook, and on the other side of a straight limb', () => {
    expect([flexion, extension]).toEqual([`${joints[1]} flexion`, `${joints[1]} extension`])
    for (const { lines, error } of made.jointAreas) {
      expect(lines).toBeGreaterThan(1)
      expect(error).toBeLessThan(0.2)
    }
    for (const [i, side] of [crook, 1 - crook].entries()) {
      const { width, height, data } = made.jointAreas[i]!.weights
      const heaviest = (v: number) => {
        const row = Math.round(v * height)
        return Math.max(...data.subarray(row * width, (row + 1) * width))
      }
      expect(heaviest(side)).toBeGreaterThan(0.5)
      expect(heaviest(1 - side)).toBe(0)
    }
  })

  it('sinks at most 2 mm', () => {
    const depths = made.layers.map(({ heights }) => Math.min(...heights.data))
    expect(Math.min(...depths)).toBeLessThan(-0.4)
    expect(Math.min(...depths)).toBeGreaterThan(-2)
  })

  it('shows faint creases at rest, which bending deepens, and smooths the other side', () => {
    expect(at(0)[flexion]).toBeCloseTo(0.3)
    expect(at(0)[extension]).toBeCloseTo(0.8)
    expect(at(FULL)[flexion]).toBeCloseTo(1, 2)
    expect(at(FULL)[extension]).toBeCloseTo(0, 2)
    expect(at(-30)[flexion]).toBeLessThan(0.3)
  })

  it('changes smoothly while the joint turns through its range', () => {
    let before = at(0)
    for (let step = 1; step <= 200; step++) {
      const now = at((FULL * step) / 200)
      for (const name of [flexion, extension]) expect(Math.abs(now[name]! - before[name]!)).toBeLessThan(0.03)
      before = now
    }
  })
})

it('two arms that share texels get the creases of one', () => {
  const { jointAreas } = autoWrinkles(bothSleeves(), SETTINGS)
  expect(jointAreas.map(({ drivers }) => drivers.map(({ joints }) => joints[1]).sort())).toEqual([
    ['LeftForeArm', 'RightForeArm'],
    ['LeftForeArm', 'RightForeArm'],
  ])
})

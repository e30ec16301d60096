import { autoWrinkles } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { activationsOf } from './models.ts'
import { tentacle } from './tentacle.ts'

const SETTINGS = { size: 256, areaSize: 64, tubes: true } as const
const DEGREE = Math.PI / 180
const BENT = ['link 1', 'link 2', 'link 3']

describe.each([
  ['skin', {}],
  ['cloth', { cloth: 'silk' }],
] as const)('a tentacle of %s', (_, kind) => {
  const skin = tentacle()
  const made = autoWrinkles(skin, { ...SETTINGS, ...kind })
  const activations = activationsOf(skin, made)

  it('creases at each joint inside its chain, in four directions', () => {
    const joints = made.jointAreas.map(({ drivers }) => drivers[0]!.joints[1])
    for (const joint of BENT)
      expect(
        joints.filter((one) => one === joint),
        joint,
      ).toHaveLength(4)
    expect(joints).toHaveLength(12)
  })

  it('activates one direction of one joint, by 60 degrees', () => {
    for (const { name, drivers } of made.jointAreas) {
      const [{ joints, axis }] = drivers as [(typeof drivers)[number]]
      const found = activations([[joints[1], axis!, 60 * DEGREE]])
      expect(found[name]).toBeCloseTo(1, 2)
      for (const [other, activation] of Object.entries(found))
        if (other !== name) expect(activation, other).toBeCloseTo(0, 4)
    }
  })

  it('changes smoothly', () => {
    const { name, drivers } = made.jointAreas[0]!
    const [{ joints, axis }] = drivers as [(typeof drivers)[number]]
    let before = 0
    for (let step = 1; step <= 200; step++) {
      const now = activations([[joints[1], axis!, (60 * DEGREE * step) / 200]])[name]!
      expect(Math.abs(now - before)).toBeLessThan(0.03)
      before = now
    }
  })
})

it('animations tell the directions and the angles', () => {
  const half = 20 * DEGREE
  const swung = tentacle({ rotations: [Math.sin(half), 0, 0, Math.cos(half)] })
  const { jointAreas } = autoWrinkles(swung, SETTINGS)
  expect(jointAreas).toHaveLength(BENT.length)
  for (const { drivers } of jointAreas) {
    const [{ axis, curve }] = drivers as [(typeof drivers)[number]]
    expect(axis![0]).toBeCloseTo(1)
    expect(curve[curve.length - 1]![0]).toBeCloseTo(40 * DEGREE, 3)
  }
})

it.each([
  ['a tentacle that the user did not ask for', {}, { ...SETTINGS, tubes: false }],
  ['a ribbon', { depth: 0.1 }, SETTINGS],
] as const)('%s gets nothing', (_, shape, settings) => {
  expect(autoWrinkles(tentacle(shape), settings).emptyReason).toMatch(/no joint/)
})

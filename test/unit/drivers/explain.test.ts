import type { WrinkleDriver } from 'furrow'
import { DriverProgram, explain, planDrivers, targetSource } from 'furrow/internal'
import { expect, it } from 'vitest'
import { link, morph, ramp, STRAIGHT } from '../../drivers.ts'

const drivers: WrinkleDriver[] = [
  morph('glabella', [link('browDownLeft'), link('browDownRight', 0.5)], { rule: 'min' }),
  { type: 'conflict', targets: ['browDownLeft', 'browOuterUpLeft'] },
  { type: 'area', area: 'nose', areas: [{ name: 'glabella', weight: 0.5 }], rule: 'sum', curve: STRAIGHT },
  { type: 'age', area: 'nose', curve: ramp(20, 80, 0.6) },
  { type: 'time', area: 'nose', attack: 5, release: 5 },
  { type: 'area', area: 'chin', areas: [{ name: 'chin', weight: 1 }], rule: 'sum', curve: STRAIGHT },
]

it('returns the contribution of each link and driver', () => {
  const [glabella, nose, chin] = explain(
    drivers,
    [{ name: 'glabella' }, { name: 'nose', activation: 0.1 }, { name: 'chin', activation: 0.3 }],
    {
      targetNames: ['browDown_L', 'browDown_R', 'browOuterUp_L'],
      weights: [0.9, 0.8, 0.3],
      inputs: { age: 50 },
    },
  )
  expect(glabella.activation).toBeCloseTo(0.4, 6)
  expect(glabella.parts[0].links.map(({ value }) => Math.round(10 * value) / 10)).toEqual([0.6, 0.4])
  // The area has 0.1 at rest, 0.2 from the glabella, and 0.3 by age.
  expect(nose.activation).toBeCloseTo(0.6, 6)
  expect(nose.resting).toBe(0.1)
  expect(nose.parts.map(({ driver, activation }) => [driver.type, Math.round(10 * activation) / 10])).toEqual(
    [
      ['age', 0.3],
      ['area', 0.2],
    ],
  )
  expect(chin).toEqual({ area: 'chin', activation: expect.closeTo(0.3, 6), resting: 0.3, parts: [] })
})

it('returns the inputs of a curve, its links and the result of its rule', () => {
  const links = [link('browDownLeft', 0.5, ramp(0.2, 0.7)), link('browDownRight')]
  const bent = morph('glabella', links, { rule: 'max', curve: ramp(0.2, 0.6) })
  const plan = planDrivers([bent])
  const names = ['browDownLeft', 'browDownRight']
  const program = new DriverProgram(plan, { target: targetSource(plan.inputs.target, names) })
  const state = program.createState()
  state.inputs.target.set([0.6, 0.25])
  program.evaluate(state)
  const { inputs, links: given, combined, activation } = program.explain(0, state)
  expect(inputs).toEqual([0.6, 0.25])
  expect(given).toEqual([expect.closeTo(0.4, 6), 0.25])
  expect(combined).toBeCloseTo(0.4, 6)
  expect(activation).toBeCloseTo(0.5, 6)
})

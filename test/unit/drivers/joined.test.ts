import type { AreaDriver, MorphDriver, WrinkleDriver } from 'furrow'
import { describe, expect, it } from 'vitest'
import { driven } from '../../driven.ts'
import { link, morph, ramp, STRAIGHT } from '../../drivers.ts'

/** Returns drivers that activate areas by given amounts. All read one blendshape, whose weight is 1. */
function given(activations: Record<string, number>): MorphDriver[] {
  return Object.entries(activations).map(([area, weight]) => morph(area, [link('all', weight)]))
}

const between = (area: string, from: Record<string, number>): AreaDriver => ({
  type: 'area',
  area,
  areas: Object.entries(from).map(([name, weight]) => ({ name, weight })),
  rule: 'sum',
  curve: STRAIGHT,
})

/** Evaluates drivers. Returns rounded activations by area, and the areas that drive themselves. */
function joined(
  drivers: WrinkleDriver[],
  { resting = {}, inputs = {} }: { resting?: Record<string, number>; inputs?: Record<string, number> } = {},
) {
  const { activations, plan } = driven(drivers, ['all'])
  const values = Object.entries(activations({ weights: [1], resting, inputs }))
  const rounded = values.map(([area, value]) => [area, Math.round(value * 1e6) / 1e6])
  return { ...Object.fromEntries(rounded), cyclic: plan.cyclicAreas }
}

describe('all drivers of a face', () => {
  it('add to the state at rest, up to at most 1', () => {
    const drivers = [...given({ nose: 0.25, brow: 0.5 }), ...given({ nose: 0.5 })]
    expect(joined(drivers, { resting: { brow: 0.7 } })).toEqual({ nose: 0.75, brow: 1, cyclic: [] })
  })

  it('let areas drive areas, in any order of the list', () => {
    const chain = [between('c', { b: 0.5 }), between('b', { a: 0.5, x: 1 }), between('x', { a: 0.25 })]
    // x = 0.2, b = 0.4 + 0.2, c = 0.3.
    expect(joined([...chain, ...given({ a: 0.8 })])).toEqual({ a: 0.8, c: 0.3, b: 0.6, x: 0.2, cyclic: [] })
  })

  it('ignore only areas that drive themselves', () => {
    const rules = [
      between('a', { b: 1 }),
      between('b', { a: 1 }),
      between('c', { a: 0.5 }),
      between('d', { d: 1 }),
    ]
    const result = joined([...given({ a: 0.4 }), ...rules])
    expect(result).toEqual({ a: 0.4, b: 0, c: 0.2, d: 0, cyclic: ['a', 'b', 'd'] })
  })
})

describe('drivers of application inputs', () => {
  const aging: WrinkleDriver[] = [
    { type: 'age', area: 'forehead', curve: ramp(30, 70, 0.8) },
    {
      type: 'age',
      area: 'crowsFeet',
      curve: [
        [40, 0.1],
        [60, 0.5],
      ],
    },
  ]

  it.each([
    [20, 0, 0.1],
    [30, 0, 0.1],
    [50, 0.4, 0.3],
    [80, 0.8, 0.5],
  ])('age: at %d', (age, forehead, crowsFeet) => {
    expect(joined(aging, { inputs: { age } })).toEqual({ forehead, crowsFeet, cyclic: [] })
  })

  it('age: a face is 20 until its age is set, and expressions add to the wrinkles of age', () => {
    expect(joined(aging)).toMatchObject({ forehead: 0, crowsFeet: 0.1 })
    const both = joined([...aging, ...given({ forehead: 0.5 })], { inputs: { age: 50 } })
    expect(both).toMatchObject({ forehead: 0.9, crowsFeet: 0.3 })
  })

  it('input: reads a number by name, 0 until it is set, and several can drive one area', () => {
    const drivers: WrinkleDriver[] = [
      { type: 'input', name: 'stress', area: 'glabella', curve: ramp(20, 120) },
      {
        type: 'input',
        name: 'cold',
        area: 'glabella',
        curve: [
          [-10, 0.5],
          [10, 0],
        ],
      },
    ]
    expect(joined(drivers, { inputs: { stress: 50, cold: 15 } })).toMatchObject({ glabella: 0.3 })
    expect(joined(drivers, { inputs: { stress: 50, cold: -30 } })).toMatchObject({ glabella: 0.8 })
    // Inputs are 0 until they are set. Stress 0 adds nothing, and cold 0 is in the middle of its curve.
    expect(joined(drivers)).toMatchObject({ glabella: 0.25 })
  })
})

describe('time drivers', () => {
  /** Returns the activation of an area after some seconds, divided into `frames` frames. */
  function after(from: number, to: number, seconds: number, frames: number): number {
    const { activations } = driven(
      [
        ...['brow', 'nose'].map((area) => morph(area, area)),
        { type: 'time', area: 'brow', attack: 0.1, release: 0.5 },
      ],
      ['brow', 'nose'],
    )
    // The first frame has the driven value without a delay.
    expect(activations({ weights: [from, 0.5], seconds: 9 }).brow).toBeCloseTo(from, 6)
    let shown = from
    for (let i = 0; i < frames; i++) {
      const { brow, nose } = activations({ weights: [to, 0.5], seconds: seconds / frames })
      shown = brow
      expect(nose).toBe(0.5)
    }
    return shown
  }

  it('cover 63% of the difference in their time, quickly up and slowly down', () => {
    expect(after(0, 1, 0.1, 1)).toBeCloseTo(1 - Math.exp(-1), 6)
    expect(after(1, 0, 0.5, 1)).toBeCloseTo(Math.exp(-1), 6)
    expect(after(0.2, 0.7, 0.05, 1)).toBeCloseTo(0.7 - 0.5 * Math.exp(-0.5), 6)
  })

  it.each([
    [0, 1],
    [1, 0.25],
  ])('from %d to %d do not depend on the frame rate: 10, 30 or 1000 frames a second', (from, to) => {
    const slow = after(from, to, 0.3, 3)
    expect(after(from, to, 0.3, 9)).toBeCloseTo(slow, 6)
    expect(after(from, to, 0.3, 300)).toBeCloseTo(slow, 6)
  })

  it('use only the last one of an area', () => {
    const { activations } = driven(
      [
        ...given({ brow: 1 }),
        { type: 'time', area: 'brow', attack: 50, release: 50 },
        { type: 'time', area: 'brow', attack: 0.1, release: 0.1 },
      ],
      ['all'],
    )
    activations({ weights: [0] })
    expect(activations({ weights: [1], seconds: 0.1 }).brow).toBeCloseTo(1 - Math.exp(-1), 6)
  })
})

import {
  AgeActivation,
  type AreaDriver,
  type Curve,
  Delay,
  type Driver,
  DriverSum,
  type WrinkleDriver,
} from 'furrow'
import { describe, expect, it } from 'vitest'

const STRAIGHT: Curve = [
  [0, 0],
  [1, 1],
]

/** One that gives what it is told. */
function given(activations: Record<string, number>): Driver {
  const areaNames = Object.keys(activations)
  return { areaNames, activations: Float32Array.from(Object.values(activations)), missing: [] }
}

const between = (area: string, from: Record<string, number>): AreaDriver => ({
  type: 'area',
  area,
  areas: Object.entries(from).map(([name, weight]) => ({ name, weight })),
  rule: 'sum',
  curve: STRAIGHT,
})

/** Activations by area, rounded. */
function joined(drivers: Driver[], all: WrinkleDriver[], resting: Record<string, number> = {}) {
  const sum = new DriverSum(drivers, all)
  sum.update(
    sum.areaNames.map((name) => resting[name] ?? 0),
    sum.createState(),
  )
  const values = [...sum.activations].map((value) => Math.round(value * 1e6) / 1e6)
  return { ...Object.fromEntries(sum.areaNames.map((name, i) => [name, values[i]])), cyclic: sum.cyclic }
}

describe('DriverSum', () => {
  it('adds what is at rest and every driver, to at most 1', () => {
    const drivers = [given({ nose: 0.25, brow: 0.5 }), given({ nose: 0.5 })]
    expect(joined(drivers, [], { brow: 0.7 })).toEqual({ nose: 0.75, brow: 1, cyclic: [] })
  })

  it('lets areas drive areas, each after those it reads, in whatever order they are listed', () => {
    const chain = [between('c', { b: 0.5 }), between('b', { a: 0.5, x: 1 }), between('x', { a: 0.25 })]
    // x = 0.2, b = 0.4 + 0.2, c = 0.3.
    expect(joined([given({ a: 0.8 })], chain)).toEqual({ a: 0.8, c: 0.3, b: 0.6, x: 0.2, cyclic: [] })
  })

  it('leaves out areas that drive themselves, and no others', () => {
    const rules = [
      between('a', { b: 1 }),
      between('b', { a: 1 }),
      between('c', { a: 0.5 }),
      between('d', { d: 1 }),
    ]
    const result = joined([given({ a: 0.4 })], rules)
    expect(result).toEqual({ a: 0.4, b: 0, c: 0.2, d: 0, cyclic: ['a', 'b', 'd'] })
  })
})

describe('AgeActivation', () => {
  const wrinkles = new AgeActivation([
    {
      type: 'age',
      area: 'forehead',
      curve: [
        [30, 0],
        [70, 0.8],
      ],
    },
    {
      type: 'age',
      area: 'crowsFeet',
      curve: [
        [40, 0.1],
        [60, 0.5],
      ],
    },
  ])

  it.each([
    [20, 0, 0.1],
    [30, 0, 0.1],
    [50, 0.4, 0.3],
    [80, 0.8, 0.5],
  ])('at %d', (years, forehead, crowsFeet) => {
    wrinkles.update(years)
    expect(wrinkles.activations[0]).toBeCloseTo(forehead, 6)
    expect(wrinkles.activations[1]).toBeCloseTo(crowsFeet, 6)
  })

  it('expressions add on top', () => {
    wrinkles.update(50)
    expect(joined([wrinkles, given({ forehead: 0.5 })], [])).toMatchObject({ forehead: 0.9, crowsFeet: 0.3 })
  })
})

describe('Delay', () => {
  const delay = new Delay([{ type: 'time', area: 'brow', attack: 0.1, release: 0.5 }], ['nose', 'brow'])

  /** Where an area is after some seconds at some frame rate. */
  function after(from: number, to: number, seconds: number, frames: number): number {
    const before = Float64Array.of(0, from)
    let shown = 0
    for (let i = 0; i < frames; i++) {
      const activations = Float32Array.of(0.5, to)
      delay.follow(activations, before, Float64Array.of(seconds / frames))
      shown = activations[1]
      expect(activations[0]).toBe(0.5)
    }
    return shown
  }

  it('makes up for 63% of what is missing in its time, quickly up and slowly down', () => {
    expect(after(0, 1, 0.1, 1)).toBeCloseTo(1 - Math.exp(-1), 6)
    expect(after(1, 0, 0.5, 1)).toBeCloseTo(Math.exp(-1), 6)
    expect(after(0.2, 0.7, 0.05, 1)).toBeCloseTo(0.7 - 0.5 * Math.exp(-0.5), 6)
  })

  it.each([
    [0, 1],
    [1, 0.25],
  ])('from %d to %d is the same at 10, 30 and 1000 frames a second', (from, to) => {
    const slow = after(from, to, 0.3, 3)
    expect(after(from, to, 0.3, 9)).toBeCloseTo(slow, 6)
    expect(after(from, to, 0.3, 300)).toBeCloseTo(slow, 6)
  })

  it('starts where it is driven to, without a delay', () => {
    const sum = new DriverSum([given({ brow: 1 })], [{ type: 'time', area: 'brow', attack: 5, release: 5 }])
    sum.seconds[0] = 0.01
    sum.update([0], sum.createState())
    expect(sum.activations[0]).toBe(1)
  })
})

import { parseDrivers, type WrinkleDriver } from 'furrow'
import { expect, test } from 'vitest'
import { ageDriver } from '../../../packages/furrow/src/author/auto/fit/age-driver.ts'
import { driven } from '../../driven.ts'

const CURVE = [
  [30, 0],
  [80, 1],
]

const parsed = (...drivers: object[]): WrinkleDriver[] =>
  parseDrivers(
    drivers.map((fields) => ({ type: 'age', curve: CURVE, ...fields })),
    ['brow', 'eye'],
  )

test('a face is 20 until the application sets its age', () => {
  expect(driven(parsed({ area: 'brow' })).activations()).toEqual({ brow: 0 })
})

test('a file may set the initial age of its face by the first age driver', () => {
  const drivers = parsed({ area: 'brow', initial: 55 }, { area: 'eye', initial: 80 })
  expect(driven(drivers).activations()).toEqual({ brow: 0.5, eye: 0.5 })
  expect(driven(drivers).activations({ inputs: { age: 30 } })).toEqual({ brow: 0, eye: 0 })
})

test('an invalid number of years is refused', () => {
  expect(() => parsed({ area: 'brow', initial: 'old' })).toThrow('initial')
  expect(() => parsed({ area: 'brow', initial: 2000 })).toThrow('initial')
})

test('automatic wrinkles show at rest if they were made for an age', () => {
  const region = { name: 'glabella', atRest: 0.5 } as Parameters<typeof ageDriver>[0]
  const atRest = (years: number | undefined) => driven([ageDriver(region, years)!]).activations().glabella
  expect(atRest(70)).toBeCloseTo(0.5, 2)
  expect(atRest(30)).toBe(0)
  expect(atRest(undefined)).toBe(0)
})

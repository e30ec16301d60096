import { describe, expect, it } from 'vitest'
import { combine, measurePerson } from '../../../bench/tracker/measure.ts'

/** Persons who appear in no table. */
const PERSONS = Array.from({ length: 8 }, (_, i) => 2001 + i)

describe('a face tracker with calibrated neutral and range', () => {
  const results = combine(PERSONS.map((person) => measurePerson(person, 'neutral and range')))

  it('sneers, although the source hardly scores sneers', () => expect(results.sneer).toBeGreaterThan(0.5))
  it('does not sneer in speech', () => expect(results.speech).toBeLessThan(0.1))
  it('keeps a neutral face neutral', () => expect(results.neutral).toBeLessThan(0.02))
  it('holds a smile still', () => expect(results.jitter).toBeLessThan(0.03))
  it('follows a step within 100 ms', () => expect(results.step).toBeLessThan(100))
  it('follows a ramp within 33 ms', () => expect(results.ramp).toBeLessThan(33))
  it('keeps small slow motions', () => expect(results.sine).toBeGreaterThan(0.8))
})

it('raw scores miss the targets', () => {
  const { sneer, neutral, jitter } = combine(
    PERSONS.map((person) => measurePerson(person, 'nothing', { filter: null })),
  )
  expect([sneer < 0.1, neutral > 0.1, jitter > 0.1]).toEqual([true, true, true])
})

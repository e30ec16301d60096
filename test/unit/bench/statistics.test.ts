import { describe, expect, it } from 'vitest'
import { median, ratio, spread, turns } from '../../../bench/statistics.ts'

describe('bench statistics', () => {
  it('median is the middle, whatever the order', () => {
    expect(median([9, 1, 5])).toBe(5)
    expect(median([4, 1, 3, 2])).toBe(2.5)
    expect(median([])).toBeNaN()
  })

  it('spread is the distance of the quartiles, which one outlier does not move', () => {
    expect(spread([1, 2, 3, 4, 5])).toBe(2)
    expect(spread([1, 2, 3, 4, 500])).toBe(2)
    expect(spread([7])).toBe(0)
  })

  it('every variant has one turn in each round and is first equally often', () => {
    const rounds = [0, 1, 2].map((round) => turns(3, round))
    for (const round of rounds) expect([...round].sort()).toEqual([0, 1, 2])
    expect(rounds.map(([first]) => first)).toEqual([0, 1, 2])
  })

  it('ratio does not see a round in which everything was slow', () => {
    expect(ratio([11, 110, 11], [10, 100, 10])).toBeCloseTo(1.1, 12)
    expect(median([11, 110, 120]) / median([10, 10, 100])).not.toBeCloseTo(1.1)
  })
})

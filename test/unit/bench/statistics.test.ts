import { describe, expect, it } from 'vitest'
import { median, ratio, roundOrder, spread } from '../../../bench/statistics.ts'

describe('bench statistics', () => {
  it('median does not depend on the order of the values', () => {
    expect(median([9, 1, 5])).toBe(5)
    expect(median([4, 1, 3, 2])).toBe(2.5)
    expect(median([])).toBeNaN()
  })

  it('spread is the interquartile range, which one outlier does not change', () => {
    expect(spread([1, 2, 3, 4, 5])).toBe(2)
    expect(spread([1, 2, 3, 4, 500])).toBe(2)
    expect(spread([7])).toBe(0)
  })

  it('every variant runs once in each round and comes first equally often', () => {
    const rounds = [0, 1, 2].map((round) => roundOrder(3, round))
    for (const round of rounds) expect([...round].sort()).toEqual([0, 1, 2])
    expect(rounds.map(([first]) => first)).toEqual([0, 1, 2])
  })

  it('ratio ignores rounds in which everything was slow, and rounds with one badly compiled variant', () => {
    expect(ratio([11, 110, 11], [10, 100, 10])).toBeCloseTo(1.1, 12)
    expect(ratio([13, 11, 13], [10, 12, 12])).toBeCloseTo(1.1, 12)
  })
})

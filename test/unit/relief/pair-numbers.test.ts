import { expect, it } from 'vitest'
import { PairNumbers } from '../../../packages/furrow/src/relief/pair-numbers.ts'

it('gives equal pairs one number, in the order of their first use, for any number of pairs', () => {
  const side = 40
  const numbers = new PairNumbers(side * side)
  const pairs = Array.from({ length: side * side }, (_, i) => [i % side, Math.floor(i / side)] as const)
  for (const [i, [a, b]] of pairs.entries()) expect(numbers.numberOf(a, b)).toBe(i)
  for (const [i, [a, b]] of pairs.entries()) expect(numbers.numberOf(a, b)).toBe(i)
  expect(numbers.count).toBe(side * side)
})

it('accepts pairs of vertices with 32-bit indices', () => {
  const numbers = new PairNumbers(3)
  expect([numbers.numberOf(0xfffffffe, 0), numbers.numberOf(0, 0xfffffffe)]).toEqual([0, 1])
  expect(numbers.numberOf(0xfffffffe, 0)).toBe(0)
})

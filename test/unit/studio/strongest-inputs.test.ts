import { parseDrivers } from 'furrow'
import { expect, test } from 'vitest'
import { strongestInputs } from '../../../studio/src/panels/drivers/strongest-inputs.ts'

const AREAS = ['brow', 'chin', 'neck']

/** Returns the name and the strength of the strongest inputs of the area `brow`. */
function strongest(drivers: readonly object[], count = 3): [string, number][] {
  return strongestInputs(parseDrivers(drivers, AREAS), 'brow', count).map(({ names, full }) => [
    names.join(' + '),
    Number(full.toFixed(3)),
  ])
}

const half = { type: 'morph', area: 'brow', curve: [[0, 0], [1, 0.5]] } // biome-ignore format: one line

test('blendshapes count with the activation that each gives alone, the strongest first', () => {
  const targets = [
    { name: 'weak', weight: 0.2 },
    { name: 'strong', weight: 0.9 },
    { name: 'against', weight: -1 },
    { name: 'bent', weight: 1, curve: [[0, 0], [1, 0.5]] }, // biome-ignore format: one line
  ]
  expect(strongest([{ ...half, targets }])).toEqual([
    ['strong', 0.45],
    ['bent', 0.25],
    ['weak', 0.1],
  ])
  expect(strongest([{ ...half, targets }], 1)).toEqual([['strong', 0.45]])
})

test.each([
  ['min', 0.25],
  ['product', 0.15],
])('blendshapes of the rule %s count together, because one alone shows nothing', (rule, full) => {
  const targets = [
    { name: 'a', weight: 0.6 },
    { name: 'b', weight: 0.5 },
  ]
  expect(strongest([{ ...half, rule, targets }])).toEqual([['a + b', full]])
})

test('drivers of all types count with their largest activation, and drivers of other areas do not', () => {
  const curve = [[20, 0.1], [80, 0.7], [90, 0.3]] // biome-ignore format: one line
  const drivers = [
    { type: 'age', area: 'brow', curve },
    { type: 'bone', area: 'brow', joints: ['neck', 'head'], measure: 'angle', curve: [[0, 0], [1, 0.6]] }, // biome-ignore format: one line
    { type: 'muscle', name: 'frontalis', area: 'brow', origin: [0, 0, 0], insertion: [0, 0, 1] },
    { type: 'area', area: 'brow', areas: [{ name: 'chin', weight: 0.4 }] },
    { type: 'expression', name: 'shock', targets: [], activations: [{ area: 'brow', activation: 0.8 }] },
    { type: 'morph', area: 'chin', targets: [{ name: 'jawOpen' }] },
    { type: 'time', area: 'brow', attack: 1 },
    { type: 'conflict', targets: ['a', 'b'] },
  ]
  expect(strongest(drivers, 9)).toEqual([
    ['frontalis', 1],
    ['shock', 0.8],
    ['', 0.7],
    ['head', 0.6],
    ['chin', 0.4],
  ])
})

test('an input refers to its driver and its link', () => {
  const drivers = parseDrivers(
    [
      { type: 'age', area: 'brow', curve: [[20, 0], [80, 0.3]] }, // biome-ignore format: one line
      { type: 'morph', area: 'brow', targets: [{ name: 'a', weight: 0.1 }, { name: 'b' }] },
    ],
    AREAS,
  )
  const [first, second] = strongestInputs(drivers, 'brow', 3)
  expect(first).toMatchObject({ index: 1, link: 1, names: ['b'] })
  expect(second).toMatchObject({ index: 0, link: -1, names: [] })
})

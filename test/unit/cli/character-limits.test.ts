import { CHARACTER_LIMITS, CharacterBudget } from 'furrow/internal'
import { expect, test } from 'vitest'
import { mapBytes } from '../../../packages/cli/src/auto/map-bytes.ts'

test('surfaces get wrinkles until the areas of a character are used up', () => {
  const budget = new CharacterBudget()
  expect(budget.add(100, 1)).toBeUndefined()
  expect(budget.add(61, 1)).toContain(String(CHARACTER_LIMITS.areas))
  // The surface that did not fit does not count.
  expect(budget.add(60, 1)).toBeUndefined()
  expect(budget.add(1, 1)).toContain(String(CHARACTER_LIMITS.areas))
})

test('surfaces get wrinkles until the maps have 12 MB', () => {
  const budget = new CharacterBudget()
  expect(budget.add(1, 8 << 20)).toBeUndefined()
  expect(budget.add(1, 5 << 20)).toContain('12 MB')
  expect(budget.add(1, 4 << 20)).toBeUndefined()
})

test('the first surface always gets its wrinkles', () => {
  expect(new CharacterBudget().add(200, 20 << 20)).toBeUndefined()
})

test('an image that maps or areas share counts once', () => {
  const imageOf = (size: number) => ({ name: 'map', mimeType: 'image/png', bytes: new Uint8Array(size) })
  const [normal, image] = [imageOf(1000), imageOf(10)]
  const layers = [{ name: 'lines', kind: 'detail' as const, normal, occlusion: normal, blood: normal }]
  const areas = [0, 1].map((channel) => ({ name: `area ${channel}`, image, channel, layer: 0 }))
  expect(mapBytes({ layers, areas })).toBe(1010)
})

import { expect, test } from 'vitest'
import {
  CHARACTER_LIMITS,
  CharacterBudget,
  surfaceArea,
} from '../../../packages/cli/src/auto/character-limits.ts'

/** Returns encoded wrinkles with a number of areas in one image, and maps of a size in bytes. */
function packed(areas: number, bytes: number) {
  const imageOf = (size: number) => ({ name: 'map', mimeType: 'image/png', bytes: new Uint8Array(size) })
  const [normal, image] = [imageOf(bytes), imageOf(0)]
  return {
    // Occlusion and blood share an image, which counts once.
    layers: [{ name: 'lines', kind: 'detail' as const, normal, occlusion: normal, blood: normal }],
    areas: Array.from({ length: areas }, (_, i) => ({ name: `area ${i}`, image, channel: 0, layer: 0 })),
    drivers: [],
  }
}

test('surfaces get wrinkles until the areas of a character are used up', () => {
  const budget = new CharacterBudget()
  expect(budget.add(packed(100, 1))).toBeUndefined()
  expect(budget.add(packed(61, 1))).toContain(String(CHARACTER_LIMITS.areas))
  // The surface that did not fit does not count.
  expect(budget.add(packed(60, 1))).toBeUndefined()
  expect(budget.add(packed(1, 1))).toContain(String(CHARACTER_LIMITS.areas))
})

test('surfaces get wrinkles until the maps have 12 MB', () => {
  const budget = new CharacterBudget()
  expect(budget.add(packed(1, 8 << 20))).toBeUndefined()
  expect(budget.add(packed(1, 5 << 20))).toContain('12 MB')
  expect(budget.add(packed(1, 4 << 20))).toBeUndefined()
})

test('the first surface always gets its wrinkles', () => {
  expect(new CharacterBudget().add(packed(200, 20 << 20))).toBeUndefined()
})

test('the area of a surface is that of its triangles', () => {
  const positions = [0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4]
  expect(surfaceArea({ positions, indices: [0, 1, 2, 0, 1, 3] })).toBeCloseTo(3 + 4)
})

import { AUTO_REGIONS } from 'furrow/author'
import { expect, it, test } from 'vitest'
import { regionLabel, regionName } from '../../../studio/src/labels.ts'

test.each([
  ['foreheadInnerLeft', 'Inner forehead, left'],
  ['crowsFeetRight', 'Crow’s feet, right'],
  ['chin', 'Chin'],
  ['flushCheeks', 'Redness: cheeks'],
  ['my_area2', 'My area 2'],
  ['Left', 'Left'],
])('%s is called %s', (name, label) => {
  expect(regionLabel(name)).toBe(label)
})

it('automatic regions have different names', () => {
  expect(new Set(AUTO_REGIONS.map(regionName)).size).toBe(AUTO_REGIONS.length)
})

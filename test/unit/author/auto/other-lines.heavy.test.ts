import { type AutoOptions, autoWrinkles, type Skin } from 'furrow/author'
import { strokesOf } from 'furrow/internal'
import { beforeAll, expect, test } from 'vitest'
import { skinAt } from '../../../skin-at.ts'
import { FACES } from './faces.ts'

let skin: Skin
let first: Map<string, string>

beforeAll(async () => {
  const [[, path]] = FACES
  skin = await skinAt(path)
  first = linesOf({})
})

test.each([
  ['chin', /^chin$/],
  ['crowsFeet', /^crowsFeet(Left|Right)$/],
  ['foreheadInner', /^forehead(Inner|Outer)?(Left|Right)?$/],
] as const)('only the lines of %s change with their seed', (region, names) => {
  const others = linesOf({ seeds: { [region]: 2 } })
  expect([...others.keys()]).toEqual([...first.keys()])
  const changed = [...first].flatMap(([name, lines]) => (others.get(name) === lines ? [] : [name]))
  expect(changed.length).toBeGreaterThan(0)
  expect(changed.filter((name) => !names.test(name))).toEqual([])
})

test('a seed for all regions makes the same lines as that seed for each region', () => {
  const seeds = { chin: 5, neck: 5 }
  const regions = ['chin', 'neck'] as const
  expect(linesOf({ seeds, regions })).toEqual(linesOf({ seed: 5, regions }))
})

/** Returns the wrinkle lines of each group as text. */
function linesOf(options: AutoOptions): Map<string, string> {
  const { strokes } = strokesOf(autoWrinkles(skin, { size: 512, areaSize: 64, ...options }))
  const lines = new Map<string, string>()
  for (const { group = '', points } of strokes) {
    lines.set(group, `${lines.get(group) ?? ''}${JSON.stringify(points)}`)
  }
  return lines
}

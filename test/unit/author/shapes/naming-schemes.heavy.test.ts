import { autoWrinkles, type Skin } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { SCHEMES } from '../../../rigs/naming-schemes.ts'
import { withNamesOf } from '../../../rigs/rename.ts'
import { skinAt } from '../../../skin-at.ts'
import { FACES } from '../auto/faces.ts'
import { overlap } from './overlap.ts'

let human: Skin

beforeAll(async () => {
  human = await skinAt(FACES[0]![1])
})

const make = (skin: Skin) => {
  const { areas, expressions, targets } = autoWrinkles(skin, { size: 128, areaSize: 64 })
  return { areas, expressions, targets }
}

/** Known faults: areas that a rig does not get. */
const MISSING: Partial<Record<string, readonly string[]>> = {
  MikuMikuDance: ['glabellaLeft', 'glabellaRight'],
}

const references = new Map<string, ReturnType<typeof make>>()

/** Makes the automatic wrinkles of a face with ARKit names, once for all schemes with the same blendshapes. */
function reference(skin: Skin): ReturnType<typeof make> {
  const key = skin.targets.map(({ name }) => name).join()
  const made = references.get(key) ?? make(skin)
  references.set(key, made)
  return made
}

describe("a face has the same areas with the names of any rig as with ARKit's", () => {
  test.each(Object.entries(SCHEMES))('%s', (rig, scheme) => {
    const arkit = reference(withNamesOf(human, scheme, (_, shape) => shape))
    const other = make(withNamesOf(human, scheme))
    const names = (areas: typeof arkit.areas) => areas.map(({ name }) => name).sort()
    const missing = MISSING[rig] ?? []
    expect(names(other.areas)).toEqual(names(arkit.areas).filter((name) => !missing.includes(name)))
    expect(other.areas.length).toBeGreaterThan(5)
    const overlaps = other.areas.map(({ name, weights }) =>
      overlap(weights.data, arkit.areas.find((area) => area.name === name)!.weights.data),
    )
    expect(overlaps.reduce((a, b) => a + b, 0) / overlaps.length).toBeGreaterThan(0.9)
    // Drivers and expressions use the names in the file.
    for (const { driver } of other.areas)
      for (const { name } of driver.targets) expect(other.targets).toContain(name)
    const smile = other.expressions.find(({ name }) => name === 'happy')!
    expect(smile.targets.some(({ name }) => other.targets.includes(name) || name.startsWith('mouth'))).toBe(
      true,
    )
  })
})

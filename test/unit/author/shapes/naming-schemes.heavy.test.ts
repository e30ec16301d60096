import { autoWrinkles, type Skin } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { FACES, skinAt } from '../auto/faces.ts'
import { SCHEMES, type Spell } from './naming-schemes.ts'
import { overlap } from './overlap.ts'

let human: Skin

beforeAll(async () => {
  human = await skinAt(FACES[0]![1])
})

/** The face with the shapes that a rig has, by the names of `spell`; a rig's names of both sides for one shape get a copy of half its motion. */
function spelled(spell: Spell, rename: (name: string, own: string) => string): Skin {
  const positions = human.positions
  const targets = new Map<string, Float32Array>()
  for (const { name, offsets } of human.targets) {
    const own = spell(name)
    for (const [i, one] of (own === undefined ? [] : [own].flat()).entries()) {
      const side = Array.isArray(own) ? 1 - 2 * i : 0
      const share = (vertex: number) => Math.min(1, Math.max(0, 0.5 + (side * positions[3 * vertex]!) / 0.02))
      const key = rename(Array.isArray(own) ? `${name}${side > 0 ? 'Left' : 'Right'}` : name, one)
      const sum = targets.get(key) ?? new Float32Array(offsets.length)
      targets.set(
        key,
        sum.map((value, k) => value + offsets[k]! * (side === 0 ? 1 : share(Math.floor(k / 3)))),
      )
    }
  }
  return { ...human, targets: [...targets].map(([name, offsets]) => ({ name, offsets })) }
}

const make = (skin: Skin) => {
  const { areas, expressions, targets } = autoWrinkles(skin, { size: 128, areaSize: 64 })
  return { areas, expressions, targets }
}

const references = new Map<string, ReturnType<typeof make>>()

/** Made once for all schemes with the same shapes. */
function reference(skin: Skin): ReturnType<typeof make> {
  const key = skin.targets.map(({ name }) => name).join()
  const made = references.get(key) ?? make(skin)
  references.set(key, made)
  return made
}

describe("a face has the same areas under the names of any rig as under ARKit's", () => {
  test.each(Object.entries(SCHEMES))('%s', (_, spell) => {
    const arkit = reference(spelled(spell, (name) => name))
    const other = make(spelled(spell, (_, own) => own))
    const names = (areas: typeof arkit.areas) => areas.map(({ name }) => name).sort()
    expect(names(other.areas)).toEqual(names(arkit.areas))
    expect(other.areas.length).toBeGreaterThan(5)
    const overlaps = other.areas.map(({ name, weights }) =>
      overlap(weights.data, arkit.areas.find((area) => area.name === name)!.weights.data),
    )
    expect(overlaps.reduce((a, b) => a + b, 0) / overlaps.length).toBeGreaterThan(0.9)
    // Drivers and expressions have names that the file has.
    for (const { driver } of other.areas)
      for (const { name } of driver.targets) expect(other.targets).toContain(name)
    const smile = other.expressions.find(({ name }) => name === 'happy')!
    expect(smile.targets.some(({ name }) => other.targets.includes(name) || name.startsWith('mouth'))).toBe(
      true,
    )
  })
})

import { EXPRESSIONS, findTargets } from 'furrow'
import { type AutoWrinkles, autoWrinkles, type Skin } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { describe, expect, test } from 'vitest'
import { noName, swapSide } from '../../../rigs/naming-schemes.ts'
import { skinAt } from '../../../skin-at.ts'
import { FACES } from '../auto/faces.ts'
import { overlap } from './overlap.ts'

const make = (skin: Skin) => autoWrinkles(skin, { size: 128, areaSize: 64 })

/** Returns the skin with renamed blendshapes. */
function renamed(skin: Skin, rename: (name: string, index: number) => string): Skin {
  return { ...skin, targets: skin.targets.map((target, i) => ({ ...target, name: rename(target.name, i) })) }
}

const NAMES = [
  ['none', (_: string, i: number) => noName(i)],
  ['sides swapped', swapSide],
] as const

const namesOf = ({ areas }: AutoWrinkles) => areas.map(({ name }) => name).sort()

describe.each(FACES)('the areas of %s do not depend on the names of its shapes', (_, path) => {
  test.each(NAMES)('%s', async (_, rename) => {
    const skin = await skinAt(path)
    const other = renamed(skin, rename)
    const [reference, made] = [make(skin), make(other)]
    expect(namesOf(made)).toEqual(namesOf(reference))
    const overlaps = made.areas.map(({ name, weights }) =>
      overlap(weights.data, reference.areas.find((area) => area.name === name)!.weights.data),
    )
    expect(overlaps.reduce((a, b) => a + b, 0) / overlaps.length).toBeGreaterThan(0.9)
    // Drivers and expressions refer to blendshapes by name. Each name must lead to the same motion as on the original.
    const targetsOf = (targets: readonly { name: string }[], { targets: all }: Skin) =>
      targets.flatMap(({ name }) =>
        findTargets(
          name,
          all.map(({ name }) => name),
        ),
      )
    for (const [i, { driver }] of made.areas.entries())
      expect(targetsOf(driver.targets, other).sort()).toEqual(
        targetsOf(reference.areas[i]!.driver.targets, skin).sort(),
      )
    for (const { name } of EXPRESSIONS) {
      const [a, b] = [reference, made].map(({ expressions }) => expressions.find((one) => one.name === name)!)
      expect(targetsOf(b!.targets, other).sort()).toEqual(targetsOf(a!.targets, skin).sort())
    }
  })
})

test('the areas of a face mirrored by its node are on the other side', async () => {
  const [[, path]] = FACES as readonly [readonly [string, string]]
  const document = await readDocument(path, 'test')
  for (const node of document.getRoot().listNodes()) if (node.getMesh()) node.setScale([-1, 1, 1])
  const [reference, made] = [make(await skinAt(path)), make(findSkin(document, path, 'test').skin)]
  expect(namesOf(made)).toEqual(namesOf(reference))
  const overlaps = made.areas.map(({ name, weights }) => {
    return overlap(weights.data, reference.areas.find((area) => area.name === swapSide(name))!.weights.data)
  })
  // The overlap is not complete, because lines are random on each side, and areas surround lines.
  expect(overlaps.reduce((a, b) => a + b, 0) / overlaps.length).toBeGreaterThan(0.7)
})

import { describe, expect, test } from 'vitest'
import { foldUvs } from '../../heads.ts'
import { skinOf } from './auto-changes.ts'
import {
  activationsOf,
  levelsApart,
  makeWrinkles,
  mapAttribute,
  plainFace,
  plainWrinkles,
} from './auto-variants.ts'
import { Workshop } from './workshop.ts'

const workshop = new Workshop()
const face = plainWrinkles(workshop)

describe('a texture that is used twice', () => {
  test('by left and right: both sides have one area, driven by both', async () => {
    const document = await plainFace()
    foldUvs(document)
    const made = await makeWrinkles(workshop, 'mirrored', document)
    expect(made.warned).toContain('left and right use the same texels')
    expect([...made.areas.keys()].filter((name) => /Left$|Right$/.test(name))).toEqual([])
    for (const region of ['foreheadOuter', 'crowsFeet', 'underEye', 'nasolabial', 'mouthCorner']) {
      // Drawn once, where the left side of the plain face has it.
      expect(levelsApart(face().areas.get(`${region}Left`)!.data, made.areas.get(region)!.data)).toBeLessThan(
        2,
      )
      const [left, right, both] = ['Left', 'Right', 'Both'].map((side) =>
        activationsOf(made, sidesOf(POSE_OF[region]!, side)).get(region),
      ) as [number, number, number]
      expect(left).toBeCloseTo(right, 5)
      expect(both).toBeGreaterThan(left)
    }
  })

  test('beyond the edge of its tile: it is said', async () => {
    const document = await plainFace()
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [u! + 0.3, v!])
    const made = await makeWrinkles(workshop, 'crossing', document)
    expect(made.warned).toMatch(/\d+% of the skin crosses the edges of its texture/)
  })

  test('by other parts: it is said', async () => {
    const document = await plainFace()
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [u!, 0.5 + Math.abs(v! - 0.5)])
    const made = await makeWrinkles(workshop, 'overlapping', document)
    expect(made.warned).toMatch(/\d+% of the texture is used twice: wrinkles show in both places/)
  })
})

/** What creases a region on a side. */
const POSE_OF: Readonly<Record<string, string>> = {
  foreheadOuter: 'browOuterUp',
  crowsFeet: 'cheekSquint',
  underEye: 'cheekSquint',
  nasolabial: 'mouthSmile',
  mouthCorner: 'mouthSmile',
}

function sidesOf(shape: string, side: string): Record<string, number> {
  const names = side === 'Both' ? [`${shape}Left`, `${shape}Right`] : [`${shape}${side}`]
  return Object.fromEntries(names.map((name) => [name, 0.8]))
}

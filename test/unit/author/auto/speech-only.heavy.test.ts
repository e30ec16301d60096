import { fileURLToPath } from 'node:url'
import { autoWrinkles, type Skin } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { skinAt } from '../../../skin-at.ts'

const SETTINGS = { size: 64, areaSize: 32 }

/** For each new blendshape, the weights of the ARKit blendshapes that add up to it. */
type Mixes = Readonly<Record<string, Readonly<Record<string, number>>>>

const both = (shape: string, weight: number) => ({ [`${shape}Left`]: weight, [`${shape}Right`]: weight })

/** Blendshapes of avatars that only speak. */
const TWO_SHAPES: Mixes = { mouthOpen: { jawOpen: 0.6 }, mouthSmile: both('mouthSmile', 1) }
const VISEMES: Mixes = {
  viseme_sil: {},
  viseme_PP: { ...both('mouthPress', 0.6), mouthRollLower: 0.3 },
  viseme_FF: { ...both('mouthUpperUp', 0.4), mouthRollLower: 0.5 },
  viseme_DD: { ...both('mouthStretch', 0.2), jawOpen: 0.12 },
  viseme_SS: both('mouthStretch', 0.4),
  viseme_aa: { jawOpen: 0.5 },
  viseme_E: { ...both('mouthSmile', 0.6), jawOpen: 0.2 },
  viseme_I: { ...both('mouthSmile', 0.8), jawOpen: 0.08 },
  viseme_O: { jawOpen: 0.35, mouthFunnel: 0.6 },
  viseme_U: { mouthPucker: 0.9 },
}

let human: Skin

beforeAll(async () => {
  human = await skinAt(fileURLToPath(new URL('../../../../faces/human.glb', import.meta.url)))
})

function withShapes(mixes: Mixes, rename = (name: string, _: number) => name): Skin {
  const targets = Object.entries(mixes).map(([name, mix], i) => {
    const offsets = new Float32Array(human.positions.length)
    for (const [shape, weight] of Object.entries(mix)) {
      const target = human.targets.find((one) => one.name === shape)!
      for (let k = 0; k < offsets.length; k++) offsets[k] += weight * target.offsets[k]
    }
    return { name: rename(name, i), offsets }
  })
  return { ...human, targets: targets.filter(({ offsets }) => offsets.some((value) => value !== 0)) }
}

describe.each([
  ['two mouth shapes', TWO_SHAPES],
  ['visemes', VISEMES],
])('a head that has only %s', (_, mixes) => {
  test('gets no lines across its cheeks, and a reason', () => {
    const { areas, layers, blood, emptyReason, warnings } = autoWrinkles(withShapes(mixes), SETTINGS)
    expect(areas).toEqual([])
    expect(layers).toEqual([])
    expect(blood.areas).toEqual([])
    expect(emptyReason).toContain('no blendshapes show where its eyes and mouth are')
    expect(warnings).toEqual([])
  })

  test('is recognised as a head by parting lips, whatever its shapes are called', () => {
    const skin = withShapes(mixes, (_, i) => `target_${i}`)
    expect(autoWrinkles(skin, SETTINGS).emptyReason).toContain('no blendshapes show')
  })
})

test.each([
  ['two mouth shapes', TWO_SHAPES],
  ['visemes and a smile', { ...VISEMES, mouthSmile: both('mouthSmile', 1) }],
])(
  "a head that blinks and has only %s gets folds at its mouth, and at most crow's feet elsewhere",
  (_, mixes) => {
    const blinks = { eyeBlinkLeft: { eyeBlinkLeft: 1 }, eyeBlinkRight: { eyeBlinkRight: 1 } }
    const { areas, blood } = autoWrinkles(withShapes({ ...mixes, ...blinks }), SETTINGS)
    const names = areas.map(({ name }) => name)
    expect(names).toEqual(expect.arrayContaining(['nasolabialLeft', 'nasolabialRight']))
    expect(
      names.filter((name) => !/^(nasolabial|mouthCorner|upperLip|lowerLip|chin|neck|crowsFeet)/.test(name)),
    ).toEqual([])
    expect(
      blood.areas.map(({ name }) => name).filter((name) => !/^(flushCheek|paleLips)/.test(name)),
    ).toEqual([])
  },
)

test('a head without blinks gets no lines', () => {
  const skin = { ...human, targets: human.targets.filter(({ name }) => !name.startsWith('eyeBlink')) }
  expect(autoWrinkles(skin, SETTINGS).areas).toEqual([])
})

test('flushes appear only in regions with lines', () => {
  // Brows that hardly move cause no wrinkles.
  const targets = human.targets.map(({ name, offsets }) =>
    name.startsWith('browDown')
      ? { name, offsets: Float32Array.from(offsets, (value) => 0.05 * value) }
      : { name, offsets },
  )
  const { areas, blood } = autoWrinkles({ ...human, targets }, SETTINGS)
  expect(areas.map(({ name }) => name).filter((name) => name.startsWith('glabella'))).toEqual([])
  const flushes = blood.areas.map(({ name }) => name)
  expect(flushes).not.toContain('flushBrows')
  expect(flushes).toContain('flushCheekLeft')
})

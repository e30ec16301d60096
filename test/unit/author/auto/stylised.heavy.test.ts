import { autoWrinkles, type Skin } from 'furrow/author'
import { beforeAll, expect, test } from 'vitest'
import { oddMeasures } from '../../../../packages/furrow/src/author/auto/anatomy/proportions.ts'
import { FACES, prepareFace, skinAt } from './faces.ts'

const SETTINGS = { size: 64, areaSize: 32 }

let human: Skin

beforeAll(async () => {
  const [[, path]] = FACES
  human = await skinAt(path)
})

/** A head that is stretched along an axis, blendshapes included. */
function stretched(axis: 1 | 2, factor: number): Skin {
  const scale = (vectors: ArrayLike<number>) =>
    Float32Array.from(vectors, (value, i) => (i % 3 === axis ? factor * value : value))
  return {
    ...human,
    positions: scale(human.positions),
    targets: human.targets.map(({ name, offsets }) => ({ name, offsets: scale(offsets) })),
  }
}

const regionsOf = (skin: Skin, options = {}) => {
  const { areas, missing, warnings } = autoWrinkles(skin, { ...SETTINGS, ...options })
  return { areas: areas.map(({ name }) => name), missing: missing.map(({ name }) => name), warnings }
}

test('a head without a nose gets no lines on it, and one line says why', () => {
  const { areas, missing, warnings } = regionsOf(stretched(2, 0.25))
  expect(areas.some((name) => /^nose|^nasolabial/.test(name))).toBe(false)
  expect(areas.some((name) => /^forehead/.test(name))).toBe(true)
  expect(missing).toEqual(expect.arrayContaining(['nose', 'noseRoot', 'nasolabial']))
  const said = warnings.filter((warning) => warning.includes('stylised'))
  expect(said).toHaveLength(1)
  expect(said[0]).toMatch(/the nose stands out by \d+ mm, not 12 to 70/)
})

test('regions that are asked for are made nevertheless', () => {
  const { areas, warnings } = regionsOf(stretched(2, 0.25), { regions: ['nasolabial'] })
  expect(areas).toContain('nasolabialLeft')
  expect(warnings.join()).not.toContain('stylised')
})

test('a mouth right below the eyes gets no lines round it', () => {
  const { areas } = regionsOf(stretched(1, 0.4))
  expect(areas.some((name) => /mouthCorner|Lip|chin|neck|nasolabial/.test(name))).toBe(false)
})

test('eyes that reach from nose to temple get no lines round them', () => {
  const { landmarks } = prepareFace(human).face
  const huge = { ...landmarks, outerCorner: [62, -1, 0], innerCorner: [4, -2, 0] } as const
  expect(oddMeasures(huge).flatMap(({ regions }) => regions)).toEqual(['crowsFeet', 'underEye'])
})

test.each(FACES)('%s is like people', async (_, path) => {
  const skin = await skinAt(path)
  expect(oddMeasures(prepareFace(skin).face.landmarks)).toEqual([])
})

import { autoWrinkles, type Skin } from 'furrow/author'
import { beforeAll, expect, test } from 'vitest'
import { implausibleMeasures } from '../../../../packages/furrow/src/author/auto/anatomy/proportions.ts'
import { skinAt } from '../../../skin-at.ts'
import { FACES, prepareFace } from './faces.ts'

const SETTINGS = { size: 64, areaSize: 32 }

let human: Skin

beforeAll(async () => {
  const [[, path]] = FACES
  human = await skinAt(path)
})

/** Returns the shipped head, stretched with its blendshapes along an axis. */
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

test('a head without a nose gets no lines on it, with a one-line reason', () => {
  const { areas, missing, warnings } = regionsOf(stretched(2, 0.25))
  expect(areas.some((name) => /^nose|^nasolabial/.test(name))).toBe(false)
  expect(areas.some((name) => /^forehead/.test(name))).toBe(true)
  expect(missing).toEqual(expect.arrayContaining(['nose', 'noseRoot', 'nasolabial']))
  const messages = warnings.filter((warning) => warning.includes('stylised'))
  expect(messages).toHaveLength(1)
  expect(messages[0]).toMatch(/the nose protrudes by \d+ mm, not 12 to 70/)
})

test('a requested region gets lines on such a head too', () => {
  const { areas, warnings } = regionsOf(stretched(2, 0.25), { regions: ['nasolabial'] })
  expect(areas).toContain('nasolabialLeft')
  expect(warnings.join()).not.toContain('stylised')
})

test('a mouth right below the eyes gets no lines around it', () => {
  const { areas } = regionsOf(stretched(1, 0.4))
  expect(areas.some((name) => /mouthCorner|Lip|chin|neck|nasolabial/.test(name))).toBe(false)
})

/** Returns the shipped head with mouth and nose pulled forwards. */
function muzzled(metres: number): Skin {
  const { offsets } = human.targets.find(({ name }) => name === 'mouthPucker')!
  const middle = [0, 0, 0]
  let total = 0
  for (let i = 0; i < offsets.length; i += 3) {
    const moved = Math.hypot(offsets[i]!, offsets[i + 1]!, offsets[i + 2]!)
    total += moved
    for (let k = 0; k < 3; k++) middle[k]! += moved * human.positions[i + k]!
  }
  const [x, y, z] = middle.map((sum) => sum / total) as [number, number, number]
  const positions = Float32Array.from(human.positions, (value, i) => {
    if (i % 3 !== 2) return value
    const [right, up] = [human.positions[i - 2]! - x, human.positions[i - 1]! - y - 0.012]
    const isFront = Math.min(1, Math.max(0, (value - z + 0.08) / 0.06))
    return value + metres * isFront * Math.exp(-((Math.hypot(right, up) / 0.042) ** 4))
  })
  return { ...human, positions }
}

test('a muzzle gets no folds of a human mouth, with a one-line reason', () => {
  const { areas, missing, warnings } = regionsOf(muzzled(0.05))
  expect(areas.filter((name) => /mouthCorner|Lip|chin|neck|nasolabial|^nose(Left|Right)/.test(name))).toEqual(
    [],
  )
  expect(areas.some((name) => /^forehead/.test(name))).toBe(true)
  expect(missing).toContain('nasolabial')
  expect(warnings.join()).toMatch(/the mouth protrudes by \d+ mm, not -40 to 15/)
})

test('eyes that reach from nose to temple get no lines around them', () => {
  const { landmarks, surface } = prepareFace(human).face
  const huge = { ...landmarks, outerCorner: [62, -1, 0], innerCorner: [4, -2, 0] } as const
  expect(implausibleMeasures({ landmarks: huge, surface }).flatMap(({ regions }) => regions)).toEqual([
    'crowsFeet',
    'underEye',
    'bag',
    'hood',
  ])
})

test.each(FACES)('%s counts as human', async (_, path) => {
  const skin = await skinAt(path)
  expect(implausibleMeasures(prepareFace(skin).face)).toEqual([])
})

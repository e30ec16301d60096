import { autoWrinkles, type Skin } from 'furrow/author'
import { type FoundSkin, parsePoses, withPoses } from 'furrow-files'
import { expect, test } from 'vitest'
import { sleeve } from '../author/auto/limbs/sleeve.ts'

const pose = (rotation: unknown, joint = 'LeftForeArm') => ({
  poses: [{ name: 'bent', joints: { [joint]: rotation } }],
})
const surface = (skin: Skin) => [{ skin }] as unknown as FoundSkin[]

/** Returns the full angle of the elbow in radians. */
function fullAngle(skin: Skin): number {
  const { jointAreas } = autoWrinkles(skin, { size: 64, areaSize: 32, cloth: 'leather' })
  const { curve } = jointAreas[0]!.drivers[0]!
  return curve[curve.length - 1]![0]
}

test('a pose that bends a joint farther than people do widens its full angle', () => {
  const skin = sleeve()
  expect(fullAngle(skin)).toBeCloseTo(2, 1)
  // The forearm points along +X and flexes to the front, which is a negative rotation about +Y.
  const [{ skin: posed }] = withPoses(
    surface(skin),
    parsePoses(pose([0, -Math.sin(1.2), 0, Math.cos(1.2)]), 'test'),
    'test',
  ) as [FoundSkin]
  expect(fullAngle(posed)).toBeCloseTo(2.4, 1)
})

test.each<[string, unknown, RegExp]>([
  ['no list', {}, /poses must be an array/],
  ['three numbers', pose([0, 0, 1]), /poses\[0\]\.joints\.LeftForeArm has the wrong number of items/],
  ['a rotation that is not normalised', pose([0, 0, 0.5, 0.5]), /LeftForeArm is no rotation.*normalise/],
  ['an unknown field', { poses: [], more: 1 }, /unknown field, got "more"/],
])('%s is an error that names the field', (_, json, message) => {
  expect(() => parsePoses(json, 'test')).toThrow(message)
})

test('a joint that the file lacks is an error with a suggestion', () => {
  const poses = parsePoses(pose([0, 0, 0, 1], 'LeftForearm'), 'test')
  expect(() => withPoses(surface(sleeve()), poses, 'test')).toThrow(/no joint has this name.*LeftForeArm/)
})

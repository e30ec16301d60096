import { type AutoOptions, autoWrinkles, type Skin } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { alikeness, type FlatPoint } from '../../../../bench/auto/identities/alike.ts'
import { skinLines } from '../../../../bench/auto/identities/skin-lines.ts'
import { unroll } from '../../../../packages/furrow/src/author/auto/surface/head-chart.ts'
import { skinAt } from '../../../skin-at.ts'
import { FACES, type PreparedFace, prepareFace } from './faces.ts'

const PAIRED = ['forehead', 'glabella', 'nose', 'crowsFeet', 'underEye', 'nasolabial', 'mouthCorner']
/** Regions that cross the middle of the face. */
const CROSSING = ['noseRoot', 'upperLip', 'lowerLip', 'chin', 'neck']
const SEED = 3
/** Points closer than this to the middle of the face count on both sides, millimetres. */
const MIDDLE = 1

let skin: Skin
let face: PreparedFace['face']

beforeAll(async () => {
  const [[, path]] = FACES
  skin = await skinAt(path)
  face = prepareFace(skin).face
})

/** Lines of one region on the left side, and mirrored lines of the right side, on the unrolled head. */
interface Sides {
  lines: FlatPoint[]
  others: FlatPoint[]
}

function sidesOf(options: AutoOptions): Map<string, Sides> {
  const made = autoWrinkles(skin, { size: 16, areaSize: 16, age: 50, seed: SEED, ...options })
  const sides = new Map<string, Sides>()
  for (const { region, samples } of skinLines(skin, face, made)) {
    const { lines, others } = sides.get(region) ?? { lines: [], others: [] }
    sides.set(region, { lines, others })
    for (const { position } of samples) {
      const [across, up] = unroll(...position)
      if (across > -MIDDLE) lines.push([across, up])
      if (across < MIDDLE) others.push([-across, up])
    }
  }
  return sides
}

describe('the lines of the shipped face', () => {
  const bySymmetry = new Map<number, Map<string, Sides>>()
  beforeAll(() => {
    for (const symmetry of [0, 0.5, 1]) bySymmetry.set(symmetry, sidesOf({ symmetry }))
  })

  const alike = (symmetry: number, region: string) => alikeness([bySymmetry.get(symmetry)!.get(region)!])!

  test.each([...PAIRED, ...CROSSING])('of %s are mirrored at symmetry 1', (region) => {
    expect(alike(1, region)).toBeGreaterThan(0.9)
    const { lines, others } = bySymmetry.get(1)!.get(region)!
    expect(Math.abs(others.length / lines.length - 1)).toBeLessThan(0.1)
  })

  test('are more alike on both sides with more symmetry', () => {
    const mean = (symmetry: number) => {
      const values = [...PAIRED, ...CROSSING].map((region) => alike(symmetry, region))
      return values.reduce((sum, value) => sum + value, 0) / values.length
    }
    expect(mean(0)).toBeLessThan(0.55)
    expect(mean(0.5)).toBeGreaterThan(mean(0) + 0.1)
    expect(mean(1)).toBeGreaterThan(mean(0.5) + 0.1)
  })

  test.each(PAIRED.slice(1))('on the left of %s do not depend on symmetry', (region) => {
    expect(bySymmetry.get(1)!.get(region)!.lines).toEqual(bySymmetry.get(0)!.get(region)!.lines)
  })
})

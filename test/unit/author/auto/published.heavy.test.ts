import { type AutoWrinkles, autoWrinkles } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { bankSlope } from '../../../../packages/furrow/src/author/strokes/profile.ts'
import { skinAt } from '../../../skin-at.ts'
import { FACES } from './faces.ts'
import {
  measureProfile,
  type Profile,
  restingFraction,
  SCANNED_REGIONS,
  type ScannedRegion,
} from './profilometry.ts'

const AGES = [30, 40, 50, 60, 70, 80] as const

/** Maximum depth of wrinkles of class 1, "just perceptible", millimetres (Lemperle et al. 2001). */
const PERCEPTIBLE = 0.2

/** Slope of ten degrees. A steeper bank, the raised skin beside a wrinkle, would shine as a white rim. */
const STEEPEST_BANK = 0.18

/** Minimum and maximum by region, millimetres, estimated from the sources in docs/auto-lines.md. */
const BOUNDS = {
  foreheadInnerLeft: { expressed: [0.4, 1.6], rest70: [0.25, 0.6], width: [2, 3], spacing: [7, 15] },
  crowsFeetLeft: { expressed: [0.4, 0.9], rest70: [0.3, 0.6], width: [1, 1.6], spacing: [5, 12] },
  glabellaLeft: { expressed: [1.2, 2.1], rest70: [0.4, 0.9], width: [1.7, 2.5], spacing: [4, 8] },
  nasolabialLeft: { expressed: [0.9, 2], rest70: [0.6, 1.2], width: [2.5, 4], spacing: [5, 10] },
} as const satisfies Record<ScannedRegion, object>

describe.each(FACES)('%s, its heights measured', (_, path) => {
  const made = new Map<number, AutoWrinkles>()
  const profiles = new Map<string, Profile>()

  beforeAll(async () => {
    const skin = await skinAt(path)
    for (const age of AGES) {
      const wrinkles = autoWrinkles(skin, { age, size: 1024 })
      made.set(age, wrinkles)
      for (const region of SCANNED_REGIONS)
        profiles.set(`${region} ${age}`, measureProfile(skin, wrinkles, region))
    }
  })

  const profile = (region: ScannedRegion, age: number) => profiles.get(`${region} ${age}`)!
  const atRest = (region: ScannedRegion, age: number) =>
    profile(region, age).depth * restingFraction(made.get(age)!, region, age)

  test.each(SCANNED_REGIONS)(
    'has no lines of %s at rest at 30, a trace at 50, and clear ones at 70',
    (region) => {
      expect(atRest(region, 30)).toBe(0)
      expect(atRest(region, 50)).toBeGreaterThan(0.08)
      expect(atRest(region, 50)).toBeLessThan(0.35)
      expect(atRest(region, 70)).toBeGreaterThan(2 * atRest(region, 50))
    },
  )

  test.each(SCANNED_REGIONS)('has lines of %s as deep, wide and dense as on human skin', (region) => {
    const { expressed, rest70, width, spacing } = BOUNDS[region]
    expectWithin(atRest(region, 70), rest70)
    for (const age of [30, 50, 70]) {
      expectWithin(profile(region, age).depth, expressed)
      expectWithin(profile(region, age).width, width)
      const between = profile(region, age).spacing
      if (between !== undefined) expectWithin(between, spacing)
    }
    expect(profile(region, 70).depth).toBeGreaterThan(profile(region, 30).depth)
  })

  test.each(AGES)('has no bank steep enough for a white rim at %s', (age) => {
    for (const { strokes } of made.get(age)!.layers) {
      for (const { width, depth, depths = [1], shoulder, bank } of strokes) {
        for (const side of bank ? [0, 1] : []) {
          const slope = shoulder[side] * bankSlope(depth * Math.max(...depths), width / 2, bank![side])
          expect(slope).toBeLessThan(1.02 * STEEPEST_BANK)
        }
      }
    }
  })

  test('deepens lines in the eye corners faster from 40 to 60 than from 60 to 80 (Akazaki et al. 2002)', () => {
    const [at40, at60, at80] = [40, 60, 80].map((age) => atRest('crowsFeetLeft', age))
    expect(at60 - at40).toBeGreaterThan(1.5 * (at80 - at60))
  })

  test('has hardly perceptible lines between the brows at rest at 40 (Luebberding et al. 2014)', () => {
    expect(atRest('glabellaLeft', 40)).toBeLessThan(PERCEPTIBLE)
  })

  test('has deeper lines in the eye corners than on the forehead at rest (Tamatsu et al. 2015)', () => {
    expect(atRest('crowsFeetLeft', 70)).toBeGreaterThan(atRest('foreheadInnerLeft', 70))
  })
})

function expectWithin(value: number, [low, high]: readonly [number, number]): void {
  expect(value).toBeGreaterThan(low)
  expect(value).toBeLessThan(high)
}

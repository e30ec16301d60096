import { expect, test } from 'vitest'
import { type AutoOutput, activationsOf, makeWrinkles, plainFace } from './auto-variants.ts'
import { EMOTIONS, FLOATING_BROWS, toVRoid } from './vroid.ts'
import { Workshop } from './workshop.ts'

const workshop = new Workshop()

/** Output of `furrow auto --json`. */
interface AutoReport {
  areas: { name: string; compression: number }[]
  missing: { name: string; reason: string }[]
}

async function made(name: string, shapes: typeof EMOTIONS): Promise<{ made: AutoOutput; told: AutoReport }> {
  const document = await plainFace()
  toVRoid(document, shapes)
  const made = await makeWrinkles(workshop, name, document, '--json')
  return { made, told: JSON.parse(made.printed) }
}

test('an avatar that only has emotions creases by them, with the reason why its nose has no lines', async () => {
  const { made: face, told } = await made('emotions', EMOTIONS)
  const activation = (shape: string, area: string) => activationsOf(face, { [shape]: 1 }).get(area)
  for (const side of ['Left', 'Right']) {
    expect(activation('Fcl_ALL_Surprised', `foreheadInner${side}`)).toBeGreaterThan(0.7)
    expect(activation('Fcl_ALL_Angry', `glabella${side}`)).toBeGreaterThan(0.7)
    expect(activation('Fcl_ALL_Joy', `crowsFeet${side}`)).toBeGreaterThan(0.6)
    expect(activation('Fcl_ALL_Joy', `nasolabial${side}`)).toBeGreaterThan(0.5)
  }
  for (const { compression } of told.areas) expect(compression).toBeGreaterThan(0.01)
  expect(told.missing).toEqual(
    ['Left', 'Right'].map((side) => ({
      name: `nose${side}`,
      reason: `no blendshape is noseSneer${side} or stands in for it`,
    })),
  )
})

test('for an avatar with brows floating in front of the skin, a message says that nothing moves its forehead', async () => {
  const { told } = await made('floating', FLOATING_BROWS)
  const reasons = new Map(told.missing.map(({ name, reason }) => [name, reason]))
  expect(reasons.get('foreheadInnerLeft')).toContain('shortens the skin across its lines by 0.0%')
  for (const { compression } of told.areas) expect(compression).toBeGreaterThan(0.01)
  expect(told.areas.map(({ name }) => name)).toEqual(
    expect.arrayContaining(['crowsFeetLeft', 'nasolabialLeft']),
  )
})

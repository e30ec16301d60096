import { expect, test } from 'vitest'
import { type AutoOutput, activationsOf, makeWrinkles, plainFace } from './auto-variants.ts'
import { EMOTIONS, FLOATING_BROWS, toVRoid } from './vroid.ts'
import { Workshop } from './workshop.ts'

const workshop = new Workshop()

/** Output of `furrow auto --json`. */
interface AutoReport {
  areas: { name: string; compression: number }[]
  areasWithoutLines: string[]
  missing: { name: string; reason: string }[]
}

async function made(name: string, shapes: typeof EMOTIONS): Promise<{ made: AutoOutput; told: AutoReport }> {
  const document = await plainFace()
  toVRoid(document, shapes)
  const made = await makeWrinkles(workshop, name, document, '--json')
  return { made, told: JSON.parse(made.printed) }
}

test('an avatar that only has emotions wrinkles by them, and the command says why its nose has no lines', async () => {
  const { made: face, told } = await made('emotions', EMOTIONS)
  const activation = (shape: string, area: string) => activationsOf(face, { [shape]: 1 }).get(area)
  for (const side of ['Left', 'Right']) {
    expect(activation('Fcl_ALL_Surprised', `foreheadInner${side}`)).toBeGreaterThan(0.7)
    expect(activation('Fcl_ALL_Angry', `glabella${side}`)).toBeGreaterThan(0.7)
    expect(activation('Fcl_ALL_Joy', `crowsFeet${side}`)).toBeGreaterThan(0.6)
    expect(activation('Fcl_ALL_Joy', `nasolabial${side}`)).toBeGreaterThan(0.5)
  }
  for (const { compression } of told.areas) expect(compression).toBeGreaterThan(0.01)
  const named = [...told.areas.map(({ name }) => name), ...told.areasWithoutLines]
  expect(new Set(named)).toEqual(new Set(activationsOf(face, {}).keys()))
  // The emotions hardly move the neck.
  expect(told.missing.filter(({ name }) => name !== 'neck')).toEqual(
    ['Left', 'Right'].map((side) => ({
      name: `nose${side}`,
      reason: `no blendshape is noseSneer${side} or stands in for it`,
    })),
  )
})

test('a message says that nothing moves the forehead of an avatar whose brows are in front of the skin', async () => {
  const { told } = await made('floating', FLOATING_BROWS)
  const reasons = new Map(told.missing.map(({ name, reason }) => [name, reason]))
  expect(reasons.get('foreheadInnerLeft')).toContain('the skin is compressed too little to fold')
  for (const { compression } of told.areas) expect(compression).toBeGreaterThan(0.01)
  expect(told.areas.map(({ name }) => name)).toEqual(
    expect.arrayContaining(['crowsFeetLeft', 'nasolabialLeft']),
  )
})

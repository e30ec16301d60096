import { expect, test } from 'vitest'
import { planOf } from '../../../../studio/src/first/reveal-plan.ts'

const plan = (strengths: Record<string, number>) => planOf(new Map(Object.entries(strengths)))

test('performs surprise, frown and smile in this order, and ends with the strongest', () => {
  expect(plan({ happy: 3, angry: 1, sad: 9, surprised: 2 })).toEqual({
    plan: ['surprised', 'angry', 'happy'],
    strongest: 'happy',
  })
})

test('leaves out expressions that show no wrinkle', () => {
  expect(plan({ surprised: 0, angry: 0.5, happy: 0 })).toEqual({ plan: ['angry'], strongest: 'angry' })
})

test('performs the three strongest expressions if the avatar has none of these', () => {
  expect(plan({ a: 1, b: 4, c: 0, d: 2, e: 3 })).toEqual({ plan: ['b', 'e', 'd'], strongest: 'b' })
})

test('performs nothing if no expression shows a wrinkle', () => {
  expect(plan({ surprised: 0 })).toBeNull()
  expect(plan({})).toBeNull()
})

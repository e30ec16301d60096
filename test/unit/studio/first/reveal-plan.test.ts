import { expect, test } from 'vitest'
import { planOf } from '../../../../studio/src/first/reveal-plan.ts'

const plan = (strengths: Record<string, number>) => planOf('expression', new Map(Object.entries(strengths)))

test('performs surprise, frown and smile in this order, and ends with the strongest', () => {
  expect(plan({ happy: 3, angry: 1, sad: 9, surprised: 2 })).toEqual({
    kind: 'expression',
    plan: ['surprised', 'angry', 'happy'],
    strongest: 'happy',
  })
})

test('leaves out expressions that show no wrinkle', () => {
  expect(plan({ surprised: 0, angry: 0.5, happy: 0 })).toMatchObject({ plan: ['angry'], strongest: 'angry' })
})

test('performs the three strongest expressions if the avatar has none of these', () => {
  expect(plan({ a: 1, b: 4, c: 0, d: 2, e: 3 })).toMatchObject({ plan: ['b', 'e', 'd'], strongest: 'b' })
})

test('performs nothing if no expression shows a wrinkle', () => {
  expect(plan({ surprised: 0 })).toBeNull()
  expect(plan({})).toBeNull()
})

test('performs a pose on one side of the body only', () => {
  const strengths = new Map([
    ['left elbow', 2],
    ['right elbow', 3],
    ['waist forward', 1],
    ['left knee', 1.5],
    ['right knee', 1.4],
  ])
  expect(planOf('pose', strengths)).toEqual({
    kind: 'pose',
    plan: ['right elbow', 'left knee', 'waist forward'],
    strongest: 'right elbow',
  })
})

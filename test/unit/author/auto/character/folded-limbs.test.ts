import { isFoldedAs } from 'furrow/internal'
import { expect, test } from 'vitest'

test.each([
  ['skin', 'left hand', false, true],
  ['skin', 'neck', false, true],
  ['skin', 'left elbow', false, true],
  ['skin', 'knee', false, true],
  ['skin', 'waist', false, false],
  ['cloth', 'left elbow', false, true],
  ['cloth', 'waist', false, true],
  ['cloth', 'neck', false, false],
  ['cloth', 'right hand', false, false],
  ['hard', 'left elbow', true, false],
  ['unknown', 'neck', false, false],
  // A tail is fur more often than skin, so the user has to state the kind.
  ['skin', 'chain', false, false],
  ['skin', 'chain', true, true],
  ['cloth', 'chain', true, true],
  ['hard', 'chain', true, false],
] as const)('%s at a %s, stated %s: folds %s', (kind, limb, isStated, folds) => {
  expect(isFoldedAs(kind, [limb], isStated)).toBe(folds)
})

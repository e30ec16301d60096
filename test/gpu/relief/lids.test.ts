import { expect, it } from 'vitest'
import { createHarness } from '../harness.ts'
import { bandedFace, displacedSkin, type RaisedFace, shippedFace } from './raised-face.ts'
import { cutsOf, lengthAway } from './self-intersections.ts'

/** Metres within which a cut is one that is there without relief too: heights reach as far. */
const NEAR = 0.001

/** Metres of new cuts at most, with heights of which no wrinkles are; closed lids would have 0.02 if heights near them reached as far as elsewhere. */
const FEW = 0.012

/** Cuts of a face in a pose, and those that it has without relief. */
function cutsIn(face: RaisedFace, targets: readonly string[]) {
  const { morphTargetDictionary, morphTargetInfluences } = face.skin
  for (const target of targets) morphTargetInfluences![morphTargetDictionary![target]] = 1
  const { plain, positions, triangles } = displacedSkin(face)
  return { before: cutsOf(plain.positions, plain.triangles), cuts: cutsOf(positions, triangles) }
}

const length = (cuts: ReturnType<typeof cutsOf>) => lengthAway(cuts, [], 0)

it.each([
  ['lids', ['eyeBlinkLeft', 'eyeBlinkRight', 'cheekSquintLeft', 'cheekSquintRight']],
  ['lips', ['mouthPressLeft', 'mouthPressRight', 'mouthRollUpper', 'mouthRollLower']],
])('%s of the shipped face do not cut each other more with its relief', async (_, targets) => {
  const harness = await createHarness('webgl')
  const face = await shippedFace(harness)
  const { before, cuts } = cutsIn(face, targets)
  expect(length(before)).toBeGreaterThan(0)
  expect(lengthAway(cuts, before, NEAR)).toBe(0)
  face.dispose()
  harness.dispose()
})

it.each([
  ['closed lids', ['eyeBlinkLeft', 'eyeBlinkRight']],
  ['pressed lips', ['mouthPressLeft', 'mouthPressRight']],
])('%s with bands of 2 mm all over cut each other hardly more', async (_, targets) => {
  const harness = await createHarness('webgl')
  const face = await bandedFace(harness)
  const { before, cuts } = cutsIn(face, targets)
  expect(length(before)).toBeGreaterThan(0)
  expect(length(cuts)).toBeLessThan(1.1 * length(before))
  expect(lengthAway(cuts, before, NEAR)).toBeLessThan(FEW)
  face.dispose()
  harness.dispose()
})

import { expect, it } from 'vitest'
import { createHarness } from '../harness.ts'
import { bandedFace, displacedSkin, type RaisedFace, shippedFace } from './raised-face.ts'
import { cutsOf, lengthAway } from './self-intersections.ts'

/** Distance within which a cut counts as existing without relief, metres; the reach of heights. */
const NEAR = 0.001

/** Largest length of new cuts with heights unlike any wrinkle, metres. Closed lids would reach 0.02 if nearby heights were not reduced. */
const FEW = 0.012

/** Returns the cuts of a face in a pose, and those without relief. */
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
])('%s of the shipped face do not cut each other more with relief', async (_, targets) => {
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
])('%s with 2 mm bands everywhere hardly cut each other more', async (_, targets) => {
  const harness = await createHarness('webgl')
  const face = await bandedFace(harness)
  const { before, cuts } = cutsIn(face, targets)
  expect(length(before)).toBeGreaterThan(0)
  expect(length(cuts)).toBeLessThan(1.1 * length(before))
  expect(lengthAway(cuts, before, NEAR)).toBeLessThan(FEW)
  face.dispose()
  harness.dispose()
})

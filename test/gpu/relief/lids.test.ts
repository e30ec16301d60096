import { expect, it } from 'vitest'
import { createHarness } from '../harness.ts'
import { bandedFace, displacedSkin, type RaisedFace, shippedFace } from './raised-face.ts'
import { cutsOf, lengthAway } from './self-intersections.ts'

/** Distance by which relief may move an existing intersection, metres. Heights move points by at most this distance. */
const NEAR = 0.001

/** Maximum length of new intersections where a squint presses the banks of crow's feet together, metres. */
const PRESSED = 0.006

/** Maximum length of new intersections, metres. Closed lids would have 0.02 m if heights were not reduced near other skin. */
const FEW = 0.012

/** Returns the lines along which a face intersects itself in a pose, with and without relief. */
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
])('%s of the shipped face cut each other no more with relief than without', async (_, targets) => {
  const harness = await createHarness('webgl')
  const face = await shippedFace(harness)
  const { before, cuts } = cutsIn(face, targets)
  expect(length(before)).toBeGreaterThan(0)
  expect(lengthAway(cuts, before, NEAR)).toBeLessThan(PRESSED)
  face.dispose()
  harness.dispose()
})

it.each([
  ['closed lids', ['eyeBlinkLeft', 'eyeBlinkRight']],
  ['pressed lips', ['mouthPressLeft', 'mouthPressRight']],
])('%s raised by bands of 2 mm cut each other hardly more than without relief', async (_, targets) => {
  const harness = await createHarness('webgl')
  const face = await bandedFace(harness)
  const { before, cuts } = cutsIn(face, targets)
  expect(length(before)).toBeGreaterThan(0)
  expect(length(cuts)).toBeLessThan(1.15 * length(before))
  expect(lengthAway(cuts, before, NEAR)).toBeLessThan(FEW)
  face.dispose()
  harness.dispose()
})

import { expect, it } from 'vitest'
import { createHarness } from '../harness.ts'
import { bandedFace, displacedSkin } from './banded-face.ts'
import { cutsOf, lengthAway } from './self-intersections.ts'

/** Metres within which a cut is one that is there without relief too: heights reach as far. */
const NEAR = 0.001

/** Metres of new cuts at most; closed lids would have 0.02 if heights near them reached as far as elsewhere. */
const FEW = 0.012

it.each([
  ['closed lids', ['eyeBlinkLeft', 'eyeBlinkRight']],
  ['pressed lips', ['mouthPressLeft', 'mouthPressRight']],
])(
  '%s of the shipped face cut each other where they do so without relief, and hardly elsewhere',
  async (_, targets) => {
    const harness = await createHarness('webgl')
    const face = await bandedFace(harness)
    const { morphTargetDictionary, morphTargetInfluences } = face.skin
    for (const target of targets) morphTargetInfluences![morphTargetDictionary![target]] = 1
    const { plain, positions, triangles } = displacedSkin(face)
    const before = cutsOf(plain.positions, plain.triangles)
    const cuts = cutsOf(positions, triangles)
    const length = (of: typeof cuts) => lengthAway(of, [], 0)
    expect(length(before)).toBeGreaterThan(0)
    expect(length(cuts)).toBeLessThan(1.1 * length(before))
    expect(lengthAway(cuts, before, NEAR)).toBeLessThan(FEW)
    face.dispose()
    harness.dispose()
  },
)

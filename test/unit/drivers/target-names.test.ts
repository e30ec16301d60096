import { ALIASES, EXPRESSIONS, findTargets } from 'furrow'
import { canonicalTargetName } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

describe('canonicalTargetName', () => {
  it.each([
    ['browOuterUpLeft', 'browOuterUpLeft'],
    ['browOuterUp_L', 'browOuterUpLeft'],
    ['BrowOuterUp.L', 'browOuterUpLeft'],
    ['brow_outer_up_left', 'browOuterUpLeft'],
    ['browInnerUp', 'browInnerUp'],
    ['blendShape1.browInnerUp', 'browInnerUp'],
    ['head_blendShapes.browOuterUp_R', 'browOuterUpRight'],
    ['BS_jawOpen', 'jawOpen'],
    ['Face.M_F00_000_00_Fcl_ALL_Joy', 'happy'],
    ['Face.M_F00_000_00_Fcl_EYE_Close_L', 'blinkLeft'],
    ['Fcl_MTH_A', 'viseme_aa'],
    ['vrc.v_pp', 'viseme_PP'],
    ['viseme_kk', 'viseme_kk'],
    ['aa', 'viseme_aa'],
    ['smirk.L', 'smirkLeft'],
    ['...', '...'],
    ['', ''],
  ])('%s is %s', (name, expected) => expect(canonicalTargetName(name)).toBe(expected))

  it('knows every name in the table and in the expressions, and no name means two shapes', () => {
    const all = ALIASES.flat()
    expect(new Set(all.map((name) => name.toLowerCase())).size).toBe(all.length)
    for (const [first, ...others] of ALIASES) {
      for (const name of [first, ...others]) expect(canonicalTargetName(name)).toBe(first)
    }
    const shapes = new Set(ALIASES.map(([first]) => first))
    for (const { targets } of EXPRESSIONS)
      for (const name of Object.keys(targets)) expect(shapes).toContain(name)
  })
})

describe('findTargets', () => {
  it.each([
    ['browOuterUpLeft', ['browOuterUp_R', 'browOuterUp_L'], [1]],
    ['jawOpen', ['Face.M_F00_000_00_Fcl_MTH_A', 'BS_JawOpen'], [1]],
    ['viseme_aa', ['Face.M_F00_000_00_Fcl_MTH_A'], [0]],
    ['happy', ['angry', 'joy'], [1]],
    ['browInnerUp', ['browInnerUp_R', 'browInnerUp_L'], [1, 0]],
    ['mouthLeft', ['mouth', 'mouthRight'], []],
    ['0', ['1', '0'], [1]],
    ['_neutral', ['jawOpen'], []],
    // An exact match wins over another reading of the name, and names of one rig are found on another.
    ['browInnerUp_R', ['browInnerUp_L', 'browInnerUp_R'], [1]],
    ['browUp_L', ['browUpLeft', 'browUp_L'], [1]],
    ['blendShape1.jawOpen', ['x.jawOpen'], [0]],
  ])('finds %s among %j', (name, targets, expected) => expect(findTargets(name, targets)).toEqual(expected))
})

import { ALIASES } from 'furrow'
import { describe, expect, it, test } from 'vitest'
import { hintOf } from '../../../../packages/furrow/src/author/shapes/names/hint.ts'
import { SCHEMES } from '../../../rigs/naming-schemes.ts'

const ARKIT = ALIASES.map(([first]) => first!).slice(0, 52)

test.each(Object.entries(SCHEMES))(
  'the shape and side of a blendshape follow from its name in %s',
  (_, spell) => {
    let known = 0
    for (const shape of ARKIT) {
      const own = spell(shape)
      for (const [i, name] of (own === undefined ? [] : [own].flat()).entries()) {
        const hint = hintOf(name)
        expect(hint?.shapes, name).toContain(shape)
        if (Array.isArray(own))
          expect(hint, name).toMatchObject({ match: 'part', side: ['Left', 'Right'][i] })
        known++
      }
    }
    expect(known).toBeGreaterThan(10)
  },
)

describe('hintOf', () => {
  it.each([
    ['eyeLookLeftL', 'expression', ['eyeLookOutLeft']],
    ['Eye_R_Look_L', 'expression', ['eyeLookInRight']],
    ['mouthFunnelDR', 'expression', ['mouthFunnel']],
    ['facs_bs_BrowInnerUpLeft_div2', 'expression', ['browInnerUp']],
    ['head.eCTRLMouthWide-Narrow', 'expression', ['mouthStretchLeft', 'mouthStretchRight']],
    ['eCTRLLipTopUp-DownL', 'expression', ['mouthUpperUpLeft']],
    ['facs_bs_NasalFlareLeft', 'other', []],
    ['eCTRLMouthSmile', 'expression', ['mouthSmileLeft', 'mouthSmileRight']],
    ['LipSuckRT', 'expression', ['mouthRollUpper']],
    ['まばたき', 'expression', ['eyeBlinkLeft', 'eyeBlinkRight']],
    ['mouthSmile.L.001', 'expression', ['mouthSmileLeft']],
    ['body_browDownLeft', 'expression', ['browDownLeft']],
    ['Fcl_BRW_Angry', 'expression', ['browDownLeft', 'browDownRight']],
    ['vrc.v_ou', 'viseme', ['mouthPucker']],
    ['viseme_kk', 'viseme', []],
    ['angry', 'emotion', ['browDownLeft', 'browDownRight', 'mouthFrownLeft', 'mouthFrownRight']],
    ['male', 'body', []],
    ['Fat', 'body', []],
    ['bodyWeight', 'body', []],
    ['Hide_Torso', 'hidden', []],
    ['shrinkBody', 'hidden', []],
    ['pJCMNeckBack_27', 'corrective', []],
    ['mouthSmileLeft_jawOpen', 'corrective', []],
    ['C_BlinkL_LookDownL', 'corrective', []],
    ['Tongue_Up', 'other', []],
    ['_neutral', 'other', []],
  ])('%s is of kind %s', (name, kind, shapes) => expect(hintOf(name)).toMatchObject({ kind, shapes }))

  it.each([
    ['Left_Blink', 'Left'],
    ['l_blink', 'Left'],
    ['R.blink', 'Right'],
    ['blinkR.001', 'Right'],
    ['BLINK_R', 'Right'],
    ['CTRL_L_eye_blink', 'Left'],
    ['LBrowRaise', 'Left'],
    ['rBrowDown', 'Right'],
    ['LipCornerPuller', undefined],
    ['CheekRaiser', undefined],
    ['jawL', undefined],
  ])('%s is on side %s', (name, side) => {
    const hint = hintOf(name)
    expect(hint?.side).toBe(side)
    expect(hint?.shapes).not.toEqual([])
  })

  it.each([
    'BrowRaiser',
    'browraiser',
    'eyeblinkr',
    'smiler',
    'Rage',
    'Laugh',
    'Roll',
    'EyeL',
    'lowerLipDown_R',
    'R',
  ])('the first or last letter of %s is no side', (name) => expect(hintOf(name)).toBeUndefined())

  it.each(['target_0', 'Shape12', 'smirk', 'Key 1', '', '...', 'eye_happy', 'mouthSmileLeft_50'])(
    'finds nothing in "%s"',
    (name) => expect(hintOf(name)).toBeUndefined(),
  )
})

/**
 * Rig curves of MetaHuman that animate its maps, and the masks that they show. Curves, masks and the formula are those of the head shader in
 * Epic's MetaHuman DNA Calibration. A curve's factors for the facial controls are from a public rebuild of the rig in Maya, because the real
 * ones are in the character's DNA file.
 */
export interface WrinkleCurve {
  /** Name of the area, such as `blink_L`. */
  area: string
  /** Name of the curve for normals in the rig, such as `head_wm1_normal_head_wm1_blink_L`. */
  curve: string
  /** Number of the animated map, 1 to 3. */
  set: number
  /** Mask file without extension, and its channel, 0 = R. */
  file: string
  channel: number
  /** Mask in a file of its own, as in older exports. */
  single: string
  /** Factors of facial controls, without the prefix `CTRL_expressions_`. */
  controls: Readonly<Record<string, number>>
}

/** Masks per file, in the order of the channels. */
const FILES: Readonly<Record<string, readonly string[]>> = {
  head_wm1_msk_01: ['blink_L', 'blink_R', 'browsRaiseInner_L', 'browsRaiseInner_R'],
  head_wm1_msk_02: ['browsRaiseOuter_L', 'browsRaiseOuter_R', 'chinRaise_L', 'chinRaise_R'],
  head_wm1_msk_03: ['jawOpen', 'purse_DL', 'purse_DR', 'purse_UL'],
  head_wm1_msk_04: ['purse_UR', 'squintInner_L', 'squintInner_R'],
  head_wm2_msk_01: ['browsDown_L', 'browsDown_R', 'browsLateral_L', 'browsLateral_R'],
  head_wm2_msk_02: ['mouthStretch_L', 'mouthStretch_R', 'neckStretch_L', 'neckStretch_R'],
  head_wm2_msk_03: ['noseWrinkler_L', 'noseWrinkler_R'],
  head_wm3_msk_01: ['cheekRaiseInner_L', 'cheekRaiseInner_R', 'cheekRaiseOuter_L', 'cheekRaiseOuter_R'],
  head_wm3_msk_02: ['cheekRaiseUpper_L', 'cheekRaiseUpper_R', 'smile_L', 'smile_R'],
  head_wm13_msk_01: ['lips_DL', 'lips_DR', 'lips_UL', 'lips_UR'],
}

/** Factors of controls per mask. `*` is the side, L or R, and `#` is Left or Right. Lips have different factors in the maps 1 and 3. */
const CONTROLS: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  blink: { 'eyeBlink*': 1, 'eyeLookDown*': 1 },
  browsRaiseInner: { 'browRaiseIn*': 1 },
  browsRaiseOuter: { 'browRaiseOuter*': 1 },
  chinRaise: { 'jawChinRaiseD*': 1, 'mouthLipsTogetherU*': 0.25, 'mouthLipsTogetherD*': 0.25 },
  jawOpen: { jawOpen: 1 },
  purse_D: { 'mouthLipsPurseD*': 0.528 },
  purse_U: { 'mouthLipsPurseU*': 0.528 },
  squintInner: { 'eyeBlink*': 0.3, 'eyeSquintInner*': 0.8 },
  browsDown: { 'browDown*': 1, 'noseWrinkle*': 0.2 },
  browsLateral: { 'browLateral*': 1, 'noseWrinkle*': 0.3 },
  mouthStretch: { 'mouthStretch*': 1 },
  neckStretch: { 'neckStretch*': 1 },
  noseWrinkler: { 'noseWrinkle*': 1 },
  cheekRaiseInner: { 'eyeCheekRaise*': 0.8, 'mouthCornerPull*': 0.8, 'mouth#': 0.5 },
  cheekRaiseOuter: { 'eyeCheekRaise*': 0.8, 'mouthCornerPull*': 0.8, 'mouth#': 0.5 },
  cheekRaiseUpper: { 'eyeCheekRaise*': 0.8 },
  smile: { 'mouthCornerPull*': 1, 'mouthDimple*': 0.4, 'mouth#': 1 },
  lips1: { mouthLeft: 0.5, mouthRight: 0.5, 'mouthLipsPurseU*': 0.625 },
  lips3: { 'mouthCornerPull*': 1, 'mouthDimple*': 0.5, 'mouthStretch*': 1 },
}

export const CURVES: readonly WrinkleCurve[] = Object.entries(FILES).flatMap(([file, masks]) => {
  const family = /wm\d+/.exec(file)![0]
  const sets = family === 'wm13' ? [1, 3] : [Number(family.slice(2))]
  return sets.flatMap((set) =>
    masks.map((mask, channel) => {
      const lips = set === 1 ? 'lipsPurse' : 'lipsSmile'
      return {
        area: mask.replace(/^lips/, lips),
        curve: `head_wm${set}_normal_head_${family}_${mask}`,
        set,
        file,
        channel,
        single: `head_${family}_${mask}`,
        controls: controlsOf(mask, set),
      }
    }),
  )
})

function controlsOf(mask: string, set: number): Record<string, number> {
  const [, name, side] = /^(.*?)(?:_?([LR]))?$/.exec(mask)!
  const factors = CONTROLS[name.startsWith('lips') ? `lips${set}` : name]
  const words = { '*': side ?? '', '#': side === 'L' ? 'Left' : 'Right' }
  const entries = Object.entries(factors).map(([control, factor]) => [
    control.replace(/[*#]/, (star) => words[star as keyof typeof words]),
    factor,
  ])
  return Object.fromEntries(entries)
}

/** ARKit's blendshapes that are nearest to a control, without sides. */
export const ARKIT_NAMES: Readonly<Record<string, string>> = {
  browRaiseIn: 'browInnerUp',
  browRaiseOuter: 'browOuterUp',
  browLateral: 'browDown',
  eyeSquintInner: 'eyeSquint',
  eyeCheekRaise: 'cheekSquint',
  noseWrinkle: 'noseSneer',
  mouthCornerPull: 'mouthSmile',
  mouthLipsPurseU: 'mouthPucker',
  mouthLipsPurseD: 'mouthPucker',
  mouthLipsTogetherU: 'mouthClose',
  mouthLipsTogetherD: 'mouthClose',
  jawChinRaiseD: 'mouthShrugLower',
}

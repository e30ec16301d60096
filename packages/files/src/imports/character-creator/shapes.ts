import { RULES, type Side } from './rules.ts'

/** A blendshape that activates rules, with its factor for each. */
export interface ShapeLink {
  shape: string
  rule: string
  side: Side
  factor: number
}

const PURSE = (factor: number) => ({ purseD: factor, purseU: factor, lipsPurseD: factor, lipsPurseU: factor })
const LIPS = (factor: number) => ({ lipsSmileD: factor, lipsSmileU: factor })

/** Factors of the rules per blendshape. `*` is L or R, `#` is Left or Right; the rules then are on that side, or with `!` on the other. */
type Shapes = Readonly<Record<string, Readonly<Record<string, number>>>>

/** Blendshapes that characters with the standard and with MetaHuman's names share. */
const SHARED: Shapes = {
  'Brow_Raise_Outer_*': { browRaiseOuter: 1 },
  'Eye_Blink_*': { blink: 1, squintInner: 0.3 },
  'Nose_Nostril_Raise_*': { noseWrinkler: 0.6 },
  Jaw_Open: { jawOpen: 1 },
  Mouth_Up: { chinRaise: 1 },
  'Mouth_Dimple_*': { cheekRaiseInner: 0.15, cheekRaiseOuter: 0.15, smile: 0.3, ...LIPS(0.3) },
  'Mouth_Stretch_*': { mouthStretch: 1 },
  Mouth_Pucker: { ...PURSE(1), chinRaise: 0.5 },
  Mouth_Chin_Up: { chinRaise: 1 },
  'Head_Turn_*!': { neckStretch: 0.6 },
  'Head_Tilt_*!': { neckStretch: 0.75 },
  Head_Backward: { jawOpen: 0.5 },
  V_Tight_O: PURSE(0.7),
  V_Tight: PURSE(0.7),
  V_Wide: LIPS(0.7),
  AE: { jawOpen: 0.24 },
  Ah: { jawOpen: 0.6 },
  EE: LIPS(0.7),
  Ih: { jawOpen: 0.15 },
  K_G_H_NG: { jawOpen: 0.065 },
  Oh: { jawOpen: 0.6025, ...PURSE(0.56) },
  R: { jawOpen: 0.1, ...PURSE(0.63) },
  S_Z: LIPS(0.14),
  T_L_D_N: { jawOpen: 0.0426 },
  Th: { jawOpen: 0.1212 },
  W_OO: PURSE(0.56),
}

const BROW_RAISE = { browRaiseInner: 1, browsLateral: 0.03 }
const BROW_DROP = { browsDown: 0.1, browsLateral: 1 }
const SNEER = { browsDown: 0.7, browsLateral: 0.6, noseWrinkler: 1 }
const CHEEK_RAISE = { cheekRaiseInner: 0.3, cheekRaiseOuter: 0.7, cheekRaiseUpper: 1 }
const SMILE = { cheekRaiseInner: 0.6, cheekRaiseOuter: 0.6, smile: 1, ...LIPS(1), noseCrease: 0.7 }
const SHARP_SMILE = { cheekRaiseInner: 0.4, cheekRaiseOuter: 0.4, smile: 0.8, ...LIPS(0.8), noseCrease: 0.7 }
const SHIFT = { smile: 0.8, cheekRaiseOuter: 0.6 }
const SHIFTED_LIPS = { lipsPurseD: 0.7, lipsPurseU: 0.7 }

const STANDARD: Shapes = {
  ...SHARED,
  'Brow_Raise_Inner_*': BROW_RAISE,
  'Brow_Drop_*': BROW_DROP,
  'Brow_Compress_*': { browsLateral: 1 },
  'Eye_Squint_*': { squintInner: 1 },
  'Eye_*_Look_Down': { blink: 1 },
  'Nose_Sneer_*': SNEER,
  'Nose_Crease_*': { noseCrease: 0.7 },
  'Cheek_Raise_*': CHEEK_RAISE,
  'Jaw_*': { neckStretch: 1 },
  'Mouth_*': SHIFT,
  Mouth_L: SHIFTED_LIPS,
  Mouth_R: SHIFTED_LIPS,
  'Mouth_Smile_*': SMILE,
  'Mouth_Smile_Sharp_*': SHARP_SMILE,
  'Mouth_Pucker_Up_*': { purseU: 1, lipsPurseU: 1 },
  'Mouth_Pucker_Down_*': { chinRaise: 0.5, purseD: 1, lipsPurseD: 1 },
  'Mouth_Up_Upper_*': { noseCrease: 1 },
  'Neck_Tighten_*': { neckStretch: 1 },
  'Mouth_Frown_*': { mouthStretch: 1 },
  Mouth_Shrug_Lower: { chinRaise: 1 },
  V_Open: { jawOpen: 1 },
}

/** Names of Character Creator 5's characters with MetaHuman's facial profile. */
const METAHUMAN_PROFILE: Shapes = {
  ...SHARED,
  'Brow_Raise_In_*': BROW_RAISE,
  'Brow_Down_*': BROW_DROP,
  'Brow_Lateral_*': { browsLateral: 1 },
  'Eye_Squint_Inner_*': { squintInner: 1 },
  'Eye_Look_Down_*': { blink: 1 },
  'Nose_Wrinkle_*': SNEER,
  'Nose_Nasolabial_Deepen_*': { noseCrease: 0.7 },
  'Eye_Cheek_Raise_*': CHEEK_RAISE,
  'Jaw_#': { neckStretch: 1 },
  'Mouth_#': SHIFT,
  Mouth_Left: SHIFTED_LIPS,
  Mouth_Right: SHIFTED_LIPS,
  'Mouth_Corner_Pull_*': SMILE,
  'Mouth_SharpCorner_Pull_*': SHARP_SMILE,
  'Mouth_StretchLips_Close_*': { mouthStretch: 1 },
  'Mouth_Lips_Purse_U*': { purseU: 1, lipsPurseU: 1 },
  'Mouth_Lips_Purse_D*': { chinRaise: 0.5, purseD: 1, lipsPurseD: 1 },
  'Mouth_UpperLip_Raise_*': { noseCrease: 1 },
  'Neck_Stretch_*': { neckStretch: 1 },
  'Mouth_Corner_Depress_*': { mouthStretch: 1 },
  Jaw_Chin_Raise_DL: { chinRaise: 1 },
  Jaw_Chin_Raise_DR: { chinRaise: 1 },
  V_Open: { jawOpen: 0.6 },
}

/** Returns which of a face's blendshapes activate which rules. Names count whatever their case. */
export function shapeLinks(targets: readonly string[]): ShapeLink[] {
  const named = new Map(targets.map((target) => [target.toLowerCase(), target]))
  const isMetahuman = named.has('brow_down_l') || named.has('brow_down_r')
  return Object.entries(isMetahuman ? METAHUMAN_PROFILE : STANDARD).flatMap(([pattern, factors]) => {
    return patternSides(pattern).flatMap(({ shape, sides }) => {
      const own = named.get(shape.toLowerCase())
      if (own === undefined) return []
      return Object.entries(factors).flatMap(([rule, factor]) => {
        const { isSided } = RULES.find(({ key }) => key === rule)!
        return (isSided ? sides : sides.slice(0, 1)).map((side) => ({ shape: own, rule, side, factor }))
      })
    })
  })
}

function patternSides(pattern: string): { shape: string; sides: Side[] }[] {
  if (!/[*#]/.test(pattern)) return [{ shape: pattern, sides: ['L', 'R'] }]
  const words = pattern.includes('#') ? { L: 'Left', R: 'Right' } : { L: 'L', R: 'R' }
  const isCrossed = pattern.endsWith('!')
  return (['L', 'R'] as const).map((side) => ({
    shape: pattern.replace(/[*#]/, words[side]).replace('!', ''),
    sides: [isCrossed === (side === 'L') ? 'R' : 'L'],
  }))
}

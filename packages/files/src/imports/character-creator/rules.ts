/**
 * Names and numbers of Character Creator's wrinkle system, as CC/iC Blender Tools 2.4.0 (`wrinkle.py`, `jsonutils.py`, `params.py`) and CC
 * Unity Tools (`WrinkleManager.cs`, `RL_HeadShaderWrinkle`) use them.
 */

/** Sides of the face. A rule without sides covers both. */
export type Side = 'L' | 'R'

/** A group of wrinkles on one or both sides. */
export interface Rule {
  /** Name without side. */
  key: string
  /** Name in the JSON file, for each side. */
  names: Readonly<Record<Side, string>>
  /** Number of the set of maps, 1 to 3. */
  set: number
  /** Mask file and channel (0 = R) that show where the wrinkles are. */
  mask: MaskName
  channel: number
  /** Number of the region, 1 to 13, that shares a strength and a power. */
  region: number
  isSided: boolean
}

/** Mask files, which the add-ons ship in their folder `textures` as `RL_WrinkleMask_Set1A.png` and so on. */
export const MASKS = ['Set1A', 'Set1B', 'Set2', 'Set3', 'Set123'] as const
export type MaskName = (typeof MASKS)[number]

/** Key, set, prefix of the name, mask, channel, region. */
const TABLE: readonly (readonly [string, number, string, MaskName, number, number])[] = [
  ['blink', 1, 'wm1', 'Set1A', 0, 3],
  ['browRaiseInner', 1, 'wm1', 'Set1A', 1, 1],
  ['purseD', 1, 'wm1', 'Set1A', 2, 8],
  ['purseU', 1, 'wm1', 'Set1A', 3, 8],
  ['browRaiseOuter', 1, 'wm1', 'Set1B', 0, 1],
  ['chinRaise', 1, 'wm1', 'Set1B', 1, 11],
  ['jawOpen', 1, 'wm1', 'Set1B', 2, 12],
  ['squintInner', 1, 'wm1', 'Set1B', 3, 4],
  ['lipsPurseD', 1, 'wm13', 'Set123', 0, 8],
  ['lipsPurseU', 1, 'wm13', 'Set123', 1, 8],
  ['browsDown', 2, 'wm2', 'Set2', 0, 2],
  ['browsLateral', 2, 'wm2', 'Set2', 1, 2],
  ['mouthStretch', 2, 'wm2', 'Set2', 2, 10],
  ['neckStretch', 2, 'wm2', 'Set2', 3, 13],
  ['noseWrinkler', 2, 'wm2', 'Set123', 2, 5],
  ['noseCrease', 2, 'wm2', 'Set123', 3, 7],
  ['cheekRaiseInner', 3, 'wm3', 'Set3', 0, 6],
  ['cheekRaiseOuter', 3, 'wm3', 'Set3', 1, 6],
  ['cheekRaiseUpper', 3, 'wm3', 'Set3', 2, 6],
  ['smile', 3, 'wm3', 'Set3', 3, 9],
  ['lipsSmileD', 3, 'wm13', 'Set123', 0, 9],
  ['lipsSmileU', 3, 'wm13', 'Set123', 1, 9],
  ['browRaiseCorrection', 3, 'wm3', 'Set1A', 1, 1],
]

export const RULES: readonly Rule[] = TABLE.map(([key, set, prefix, mask, channel, region]) => {
  const isSided = key !== 'jawOpen'
  const nameOf = (side: Side) => `head_wm${set}_normal_head_${prefix}_${isSided ? sided(key, side) : key}`
  return { key, names: { L: nameOf('L'), R: nameOf('R') }, set, mask, channel, region, isSided }
})

/** Returns the last part of a rule's name, such as `lips_DL`, `purse_UR` or `blink_L`. */
function sided(key: string, side: Side): string {
  const quarter = /^(lips|purse)\w*([DU])$/.exec(key)
  return quarter ? `${quarter[1]}_${quarter[2]}${side}` : `${key}_${side}`
}

/**
 * The overlap of these two rules moves to `browRaiseCorrection`: raised brows that are also drawn together have creases of their own. Both
 * lose the smaller of their values.
 */
export const CORRECTION = { rules: ['browRaiseInner', 'browsLateral'], to: 'browRaiseCorrection' } as const

/** Names of the 13 regions, in order. */
export const REGIONS = [
  'browRaise',
  'browDrop',
  'blink',
  'squint',
  'nose',
  'cheekRaise',
  'nostrilCrease',
  'purseLips',
  'smileLips',
  'mouthStretch',
  'chin',
  'jaw',
  'neckStretch',
] as const

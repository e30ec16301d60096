/** Returns a rig's name for an ARKit blendshape: undefined if the rig lacks it, two names if the rig has one per side. */
export type NamingScheme = (shape: string) => string | [left: string, right: string] | undefined

/** Splits an ARKit name into stem and side. */
function sideOf(shape: string): [stem: string, side: '' | 'Left' | 'Right'] {
  const [, stem, side] = /^(.*?)(Left|Right)?$/.exec(shape)!
  return /^(jaw|mouth)(Left|Right)$/.test(shape) ? [shape, ''] : [stem!, (side as 'Left' | 'Right') ?? '']
}

/** Returns the scheme of a rig. `names` has the rig's name for each stem of ARKit. In a rig's name, `sides` replace `*`. */
function rig(sides: [left: string, right: string], names: Readonly<Record<string, string>>): NamingScheme {
  return (shape) => {
    const [stem, side] = sideOf(shape)
    const name = names[stem]
    if (name === undefined) return undefined
    const sideNames = sides.map((one) => name.replace('*', one)) as [string, string]
    if (!name.includes('*')) return name
    return side === '' ? sideNames : sideNames[side === 'Left' ? 0 : 1]
  }
}

const upper = (shape: string) => shape.charAt(0).toUpperCase() + shape.slice(1)

const METAHUMAN = {
  browDown: 'browDown*',
  browInnerUp: 'browRaiseIn*',
  browOuterUp: 'browRaiseOuter*',
  cheekSquint: 'eyeCheekRaise*',
  cheekPuff: 'mouthCheekBlow*',
  eyeBlink: 'eyeBlink*',
  eyeSquint: 'eyeSquintInner*',
  eyeWide: 'eyeWiden*',
  jawOpen: 'jawOpen',
  mouthDimple: 'mouthDimple*',
  mouthFrown: 'mouthCornerDepress*',
  mouthFunnel: 'mouthFunnelU*',
  mouthLowerDown: 'mouthLowerLipDepress*',
  mouthPress: 'mouthLipsPress*',
  mouthPucker: 'mouthLipsPurseU*',
  mouthRollLower: 'mouthLowerLipRollIn*',
  mouthRollUpper: 'mouthUpperLipRollIn*',
  mouthShrugLower: 'jawChinRaiseD*',
  mouthShrugUpper: 'jawChinRaiseU*',
  mouthSmile: 'mouthCornerPull*',
  mouthStretch: 'mouthStretch*',
  mouthUpperUp: 'mouthUpperLipRaise*',
  noseSneer: 'noseWrinkle*',
}

const prefixed = (prefix: string, names: Readonly<Record<string, string>>) =>
  Object.fromEntries(Object.entries(names).map(([shape, name]) => [shape, `${prefix}${name}`]))

const OPPOSITE: Readonly<Record<string, string>> = { Left: 'Right', Right: 'Left', _L: '_R', _R: '_L' }

/** Replaces left by right at the end of a name, and right by left. */
export function swapSide(name: string): string {
  return name.replace(/(Left|Right|_L|_R)$/, (side) => OPPOSITE[side]!)
}

/** Returns a meaningless name. */
export function noName(index: number): string {
  return `target_${index}`
}

/** Naming schemes of rigs that have ARKit's blendshapes under other names. */
export const SCHEMES: Readonly<Record<string, NamingScheme>> = {
  MetaHuman: rig(['L', 'R'], METAHUMAN),
  'MetaHuman with CTRL_expressions_': rig(['L', 'R'], prefixed('CTRL_expressions_', METAHUMAN)),
  iClone: (shape) => `A01_${upper(shape).replace(/(\p{Ll})(\p{Lu})/gu, '$1_$2')}`,
  'Character Creator 4': rig(['L', 'R'], {
    browDown: 'Brow_Drop_*',
    browInnerUp: 'Brow_Raise_Inner_*',
    browOuterUp: 'Brow_Raise_Outer_*',
    cheekPuff: 'Cheek_Puff_*',
    cheekSquint: 'Cheek_Raise_*',
    eyeBlink: 'Eye_Blink_*',
    eyeLookDown: 'Eye_*_Look_Down',
    eyeLookUp: 'Eye_*_Look_Up',
    eyeSquint: 'Eye_Squint_*',
    eyeWide: 'Eye_Wide_*',
    jawForward: 'Jaw_Forward',
    jawLeft: 'Jaw_L',
    jawOpen: 'Jaw_Open',
    jawRight: 'Jaw_R',
    mouthClose: 'Mouth_Close',
    mouthDimple: 'Mouth_Dimple_*',
    mouthFrown: 'Mouth_Frown_*',
    mouthFunnel: 'Mouth_Funnel_Up_*',
    mouthLeft: 'Mouth_L',
    mouthLowerDown: 'Mouth_Down_Lower_*',
    mouthPress: 'Mouth_Press_*',
    mouthPucker: 'Mouth_Pucker_Up_*',
    mouthRight: 'Mouth_R',
    mouthRollLower: 'Mouth_Roll_In_Lower_*',
    mouthRollUpper: 'Mouth_Roll_In_Upper_*',
    mouthShrugLower: 'Mouth_Shrug_Lower',
    mouthShrugUpper: 'Mouth_Shrug_Upper',
    mouthSmile: 'Mouth_Smile_*',
    mouthStretch: 'Mouth_Stretch_*',
    mouthUpperUp: 'Mouth_Up_Upper_*',
    noseSneer: 'Nose_Sneer_*',
  }),
  Daz: (shape) => `facs_bs_${upper(shape)}`,
  Meta: rig(['L', 'R'], {
    browDown: 'BROW_LOWERER_*',
    browInnerUp: 'INNER_BROW_RAISER_*',
    browOuterUp: 'OUTER_BROW_RAISER_*',
    cheekPuff: 'CHEEK_PUFF_*',
    cheekSquint: 'CHEEK_RAISER_*',
    eyeBlink: 'EYES_CLOSED_*',
    eyeLookDown: 'EYES_LOOK_DOWN_*',
    eyeLookUp: 'EYES_LOOK_UP_*',
    eyeSquint: 'LID_TIGHTENER_*',
    eyeWide: 'UPPER_LID_RAISER_*',
    jawForward: 'JAW_THRUST',
    jawLeft: 'JAW_SIDEWAYS_LEFT',
    jawOpen: 'JAW_DROP',
    jawRight: 'JAW_SIDEWAYS_RIGHT',
    mouthClose: 'LIPS_TOWARD',
    mouthDimple: 'DIMPLER_*',
    mouthFrown: 'LIP_CORNER_DEPRESSOR_*',
    mouthFunnel: 'LIP_FUNNELER_*B',
    mouthLeft: 'MOUTH_LEFT',
    mouthLowerDown: 'LOWER_LIP_DEPRESSOR_*',
    mouthPress: 'LIP_PRESSOR_*',
    mouthPucker: 'LIP_PUCKER_*',
    mouthRight: 'MOUTH_RIGHT',
    mouthRollLower: 'LIP_SUCK_*B',
    mouthRollUpper: 'LIP_SUCK_*T',
    mouthShrugLower: 'CHIN_RAISER_B',
    mouthShrugUpper: 'CHIN_RAISER_T',
    mouthSmile: 'LIP_CORNER_PULLER_*',
    mouthStretch: 'LIP_STRETCHER_*',
    mouthUpperUp: 'UPPER_LIP_RAISER_*',
    noseSneer: 'NOSE_WRINKLER_*',
  }),
  SRanipal: rig(['Left', 'Right'], {
    cheekPuff: 'Cheek_Puff_*',
    eyeBlink: 'Eye_*_Blink',
    eyeSquint: 'Eye_*_squeeze',
    eyeWide: 'Eye_*_Wide',
    jawForward: 'Jaw_Forward',
    jawLeft: 'Jaw_Left',
    jawOpen: 'Jaw_Open',
    jawRight: 'Jaw_Right',
    mouthFrown: 'Mouth_Sad_*',
    mouthLowerDown: 'Mouth_Lower_Down*',
    mouthPucker: 'Mouth_Pout',
    mouthRollLower: 'Mouth_Lower_Inside',
    mouthRollUpper: 'Mouth_Upper_Inside',
    mouthShrugLower: 'Mouth_Lower_Overlay',
    mouthSmile: 'Mouth_Smile_*',
    mouthUpperUp: 'Mouth_Upper_Up*',
  }),
  'Unified Expressions': rig(['Left', 'Right'], {
    browDown: 'BrowDown*',
    browInnerUp: 'BrowInnerUp*',
    browOuterUp: 'BrowOuterUp*',
    cheekPuff: 'CheekPuff*',
    cheekSquint: 'CheekSquint*',
    eyeBlink: 'EyeClosed*',
    eyeSquint: 'EyeSquint*',
    eyeWide: 'EyeWide*',
    jawOpen: 'JawOpen',
    mouthClose: 'MouthClosed',
    mouthDimple: 'MouthDimple*',
    mouthFrown: 'MouthFrown*',
    mouthFunnel: 'LipFunnel',
    mouthLowerDown: 'MouthLowerDown*',
    mouthPress: 'MouthPress*',
    mouthPucker: 'LipPucker',
    mouthShrugLower: 'MouthRaiserLower',
    mouthShrugUpper: 'MouthRaiserUpper',
    mouthSmile: 'MouthSmile*',
    mouthStretch: 'MouthStretch*',
    mouthUpperUp: 'MouthUpperUp*',
    noseSneer: 'NoseSneer*',
  }),
  MikuMikuDance: rig(['', '右'], {
    browDown: '怒り',
    browInnerUp: '困る',
    browOuterUp: '上',
    eyeBlink: 'ｳｨﾝｸ２*',
    eyeSquint: 'じと目',
    eyeWide: 'びっくり',
    jawOpen: 'あ',
    mouthFrown: '口角下げ',
    mouthPucker: 'う',
    mouthSmile: '口角上げ',
    mouthStretch: '口横広げ',
  }),
  Faceshift: rig(['L', 'R'], {
    browDown: 'BrowsD_*',
    browInnerUp: 'BrowsU_C',
    browOuterUp: 'BrowsU_*',
    cheekSquint: 'CheekSquint_*',
    cheekPuff: 'Puff',
    eyeBlink: 'EyeBlink_*',
    eyeSquint: 'EyeSquint_*',
    eyeWide: 'EyeOpen_*',
    jawOpen: 'JawOpen',
    mouthDimple: 'MouthDimple_*',
    mouthFrown: 'MouthFrown_*',
    mouthFunnel: 'LipsFunnel',
    mouthLowerDown: 'LipsLowerDown',
    mouthPucker: 'LipsPucker',
    mouthShrugLower: 'ChinLowerRaise',
    mouthShrugUpper: 'ChinUpperRaise',
    mouthSmile: 'MouthSmile_*',
    mouthStretch: 'LipsStretch_*',
    mouthUpperUp: 'LipsUpperUp',
    noseSneer: 'Sneer',
  }),
  'a copy in Blender': (shape) => `${shape}.001`,
  'prefix face_shapes.ai_': (shape) => `face_shapes.ai_${shape}`,
  'prefix char01:': (shape) => `char01:${shape}`,
  'prefix Head_': (shape) => `Head_${shape}`,
  'prefix of the mesh': (shape) => `mesh_name|${shape}`,
  'L_ and R_ first': (shape) => around(shape, { Left: 'L_', Right: 'R_' }),
  'left_ and right_ first': (shape) => around(shape, { Left: 'left_', Right: 'right_' }),
  'L and R last': (shape) => shape.replace(/(?<!jaw|mouth)(Left|Right)$/, (side) => side.charAt(0)),
}

/** Naming schemes of rigs that have fewer blendshapes, where one name replaces several of ARKit's. */
export const FEWER_SHAPES: Readonly<Record<string, NamingScheme>> = {
  VRoid: rig(['L', 'R'], {
    browDown: 'Fcl_BRW_Angry',
    browInnerUp: 'Fcl_BRW_Surprised',
    browOuterUp: 'Fcl_BRW_Surprised',
    cheekSquint: 'Fcl_EYE_Joy_*',
    eyeBlink: 'Fcl_EYE_Close_*',
    eyeSquint: 'Fcl_EYE_Joy_*',
    eyeWide: 'Fcl_EYE_Spread',
    jawOpen: 'Fcl_MTH_A',
    mouthFrown: 'Fcl_MTH_Sorrow',
    mouthFunnel: 'Fcl_MTH_O',
    mouthPucker: 'Fcl_MTH_Small',
    mouthSmile: 'Fcl_MTH_Fun',
    mouthStretch: 'Fcl_MTH_Large',
  }),
  "VRM's emotions, Oculus' visemes": rig(['Left', 'Right'], {
    browDown: 'angry',
    browInnerUp: 'surprised',
    browOuterUp: 'surprised',
    cheekSquint: 'happy',
    eyeBlink: 'blink*',
    eyeSquint: 'happy',
    eyeWide: 'surprised',
    jawOpen: 'viseme_aa',
    mouthFrown: 'angry',
    mouthFunnel: 'viseme_O',
    mouthPucker: 'viseme_U',
    mouthSmile: 'happy',
    mouthStretch: 'viseme_I',
  }),
  'visemes and blinks only': rig(['Left', 'Right'], {
    eyeBlink: 'blink*',
    jawOpen: 'viseme_aa',
    mouthFunnel: 'viseme_O',
    mouthPucker: 'viseme_U',
    mouthStretch: 'viseme_I',
  }),
}

function around(shape: string, prefixes: { Left: string; Right: string }): string {
  const [stem, side] = sideOf(shape)
  return side === '' ? stem : `${prefixes[side]}${stem}`
}

/** Names, without `Left` and `Right`, of ARKit blendshapes that exist for both sides. MediaPipe uses ARKit's names. */
export const BOTH_SIDES: readonly string[] = [
  'browDown',
  'browOuterUp',
  'cheekSquint',
  'eyeBlink',
  'eyeLookDown',
  'eyeLookIn',
  'eyeLookOut',
  'eyeLookUp',
  'eyeSquint',
  'eyeWide',
  'mouthDimple',
  'mouthFrown',
  'mouthLowerDown',
  'mouthPress',
  'mouthSmile',
  'mouthStretch',
  'mouthUpperUp',
  'noseSneer',
]

/** Names of the ARKit blendshapes that have no side. */
export const CENTRAL: readonly string[] = [
  'browInnerUp',
  'cheekPuff',
  'jawForward',
  'jawLeft',
  'jawOpen',
  'jawRight',
  'mouthClose',
  'mouthFunnel',
  'mouthLeft',
  'mouthPucker',
  'mouthRight',
  'mouthRollLower',
  'mouthRollUpper',
  'mouthShrugLower',
  'mouthShrugUpper',
  'tongueOut',
]

const OTHER_RIGS = [
  // Visemes of Oculus and VRChat, and vowels of VRM and VRoid.
  ['viseme_sil', 'vrc.v_sil'],
  ['viseme_PP', 'vrc.v_pp'],
  ['viseme_FF', 'vrc.v_ff'],
  ['viseme_TH', 'vrc.v_th'],
  ['viseme_DD', 'vrc.v_dd'],
  ['viseme_kk', 'vrc.v_kk'],
  ['viseme_CH', 'vrc.v_ch'],
  ['viseme_SS', 'vrc.v_ss'],
  ['viseme_nn', 'vrc.v_nn'],
  ['viseme_RR', 'vrc.v_rr'],
  ['viseme_aa', 'vrc.v_aa', 'aa', 'Fcl_MTH_A'],
  ['viseme_E', 'vrc.v_e', 'ee', 'Fcl_MTH_E'],
  ['viseme_I', 'vrc.v_ih', 'ih', 'Fcl_MTH_I'],
  ['viseme_O', 'vrc.v_oh', 'oh', 'Fcl_MTH_O'],
  ['viseme_U', 'vrc.v_ou', 'ou', 'Fcl_MTH_U'],
  // Expressions of VRM 1.0, VRoid and VRM 0.x.
  ['happy', 'Fcl_ALL_Joy', 'joy'],
  ['angry', 'Fcl_ALL_Angry'],
  ['sad', 'Fcl_ALL_Sorrow', 'sorrow'],
  ['relaxed', 'Fcl_ALL_Fun', 'fun'],
  ['surprised', 'Fcl_ALL_Surprised'],
  ['blink', 'Fcl_EYE_Close'],
  ['blinkLeft', 'Fcl_EYE_Close_L'],
  ['blinkRight', 'Fcl_EYE_Close_R'],
]

/**
 * Names of blendshapes in different rigs: one list per shape, with the canonical name first. Differences of spelling, prefixes, and `_L` or
 * `_R` instead of `Left` or `Right` are not listed, because `target-names.ts` handles them. `author/shapes/names` lists more rigs.
 */
export const ALIASES: readonly (readonly string[])[] = [
  ...BOTH_SIDES.flatMap((name) => ['Left', 'Right'].map((side) => [`${name}${side}`])),
  ...CENTRAL.map((name) => [name]),
  ...OTHER_RIGS,
]

/**
 * Names of one and the same shape in different rigs; the first of each line is the one used here. Spelling, prefixes and `_L` / `_R` are
 * no matter of this table (see `target-names.ts`). ARKit's 52 are also those of MediaPipe's face landmarker, in the same spelling.
 */
const BOTH_SIDES = [
  ['browDown'],
  ['browOuterUp'],
  ['cheekSquint'],
  ['eyeBlink'],
  ['eyeLookDown'],
  ['eyeLookIn'],
  ['eyeLookOut'],
  ['eyeLookUp'],
  ['eyeSquint'],
  ['eyeWide'],
  ['mouthDimple'],
  ['mouthFrown'],
  ['mouthLowerDown'],
  ['mouthPress'],
  ['mouthSmile'],
  ['mouthStretch'],
  ['mouthUpperUp'],
  ['noseSneer'],
]

const WHOLE = [
  ['browInnerUp'],
  ['cheekPuff'],
  ['jawForward'],
  ['jawLeft'],
  ['jawOpen'],
  ['jawRight'],
  ['mouthClose'],
  ['mouthFunnel'],
  ['mouthLeft'],
  ['mouthPucker'],
  ['mouthRight'],
  ['mouthRollLower'],
  ['mouthRollUpper'],
  ['mouthShrugLower'],
  ['mouthShrugUpper'],
  ['tongueOut'],
  // Oculus' visemes, VRChat's of the same sounds, VRM's and VRoid's vowels.
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
  // VRM's expressions, VRoid's shapes and VRM 0's names.
  ['happy', 'Fcl_ALL_Joy', 'joy'],
  ['angry', 'Fcl_ALL_Angry'],
  ['sad', 'Fcl_ALL_Sorrow', 'sorrow'],
  ['relaxed', 'Fcl_ALL_Fun', 'fun'],
  ['surprised', 'Fcl_ALL_Surprised'],
  ['blink', 'Fcl_EYE_Close'],
  ['blinkLeft', 'Fcl_EYE_Close_L'],
  ['blinkRight', 'Fcl_EYE_Close_R'],
]

/** Names of one shape each, the first of them the one used here. */
export const ALIASES: readonly (readonly string[])[] = [
  ...BOTH_SIDES.flatMap((names) => ['Left', 'Right'].map((side) => names.map((name) => `${name}${side}`))),
  ...WHOLE,
]

import type { RigNames } from '../rig-names.ts'

/**
 * Blendshape names of Daz figures, without prefixes. Genesis 8.1 and 9 add `facs_bs_`, `facs_ctrl_` or `facs_jnt_`; Genesis 3 and 8 add
 * `eCTRL`. If a name has two directions, such as `BrowUp-Down`, the blendshape moves in the first one.
 */
export const DAZ: RigNames = {
  source: 'https://github.com/daz3d/DazBridgeUtils/blob/main/src/DzBridgeMorphSelectionDialog.cpp',
  same: {
    EyesClosed: 'eyeBlink',
    EyesSquint: 'eyeSquint',
    CheekEyeFlex: 'cheekSquint',
    CheeksBalloon: 'cheekPuff',
    NoseWrinkle: 'noseSneer',
    MouthSmileSimple: 'mouthSmile',
    'MouthWide-Narrow': 'mouthStretch',
    'LipTopUp-Down': 'mouthUpperUp',
    'BrowInnerUp-Down': 'browInnerUp',
    'BrowOuterUp-Down': 'browOuterUp',
  },
  parts: {
    MouthCloseUpper: 'mouthClose',
    MouthCloseLower: 'mouthClose',
    MouthFunnelUpper: 'mouthFunnel',
    MouthFunnelLower: 'mouthFunnel',
    MouthPuckerUpper: 'mouthPucker',
    MouthPuckerLower: 'mouthPucker',
    MouthPurseUpper: 'mouthPucker',
    MouthPurseLower: 'mouthPucker',
    EyelidOpenUpper: 'eyeWide',
    EyelidOpenLower: 'eyeWide',
  },
  like: {
    BrowSqueeze: 'browDown',
    'BrowUp-Down': 'browInnerUp browOuterUp',
    MouthSmileWiden: 'mouthSmile',
    MouthSmileOpen: 'mouthSmile',
    MouthNarrow: 'mouthPucker',
    MouthOpen: 'jawOpen',
  },
  visemes: {
    eCTRLvAA: 'jawOpen',
    eCTRLvOW: 'mouthFunnel',
    eCTRLvUW: 'mouthPucker',
    eCTRLvW: 'mouthPucker',
    eCTRLvEE: 'mouthStretch',
    eCTRLvEH: '',
    eCTRLvER: '',
    eCTRLvF: '',
    eCTRLvIH: '',
    eCTRLvIY: '',
    eCTRLvK: '',
    eCTRLvL: '',
    eCTRLvM: '',
    eCTRLvS: '',
    eCTRLvSH: '',
    eCTRLvT: '',
    eCTRLvTH: '',
  },
  other: ['JawRecess', 'JawChinCompression', 'NasalFlare', 'NasalCompress', 'NostrilsFlare'],
}

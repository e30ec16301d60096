import type { RigNames } from '../rig-names.ts'

/** Names of Faceshift's 48 blendshapes, which Hifi (now Overte) avatars also use. */
export const FACESHIFT: RigNames = {
  source:
    'https://github.com/vircadia/vircadia-native-core/blob/97a0edf026513eee77c69e4e1a0ecbabb648aed4/libraries/shared/src/FaceshiftConstants.cpp',
  same: {
    BrowsD: 'browDown',
    BrowsU_C: 'browInnerUp',
    BrowsU: 'browOuterUp',
    EyeOpen: 'eyeWide',
    EyeDown: 'eyeLookDown',
    EyeUp: 'eyeLookUp',
    EyeIn: 'eyeLookIn',
    EyeOut: 'eyeLookOut',
    JawFwd: 'jawForward',
    Puff: 'cheekPuff',
    Sneer: 'noseSneer',
    LipsFunnel: 'mouthFunnel',
    LipsPucker: 'mouthPucker',
    LipsStretch: 'mouthStretch',
    ChinLowerRaise: 'mouthShrugLower',
    ChinUpperRaise: 'mouthShrugUpper',
    LipsUpperUp: 'mouthUpperUp',
    LipsLowerDown: 'mouthLowerDown',
    LipsUpperClose: 'mouthRollUpper',
    LipsLowerClose: 'mouthRollLower',
  },
  like: { LipsUpperOpen: 'mouthFunnel', LipsLowerOpen: 'mouthFunnel', JawChew: 'mouthClose' },
}

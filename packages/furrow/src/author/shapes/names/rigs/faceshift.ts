import type { RigNames } from '../rig-names.ts'

/** Faceshift's 48 shapes, which Hifi (now Overte) avatars have too. */
export const FACESHIFT: RigNames = {
  source: 'https://docs.overte.org/en/latest/create/avatars/avatar-standards.html',
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

import type { RigNames } from '../rig-names.ts'

/** Blendshape names of SRanipal, HTC's face tracking. SRanipal does not track brows. */
export const SRANIPAL: RigNames = {
  source: 'https://docs.vrcft.io/docs/tutorial-avatars/tutorial-avatars-extras/compatibility/overview',
  same: {
    'Eye_*_Blink': 'eyeBlink',
    'Eye_*_Wide': 'eyeWide',
    'Eye_*_Squeeze': 'eyeSquint',
    'Eye_*_Up': 'eyeLookUp',
    'Eye_*_Down': 'eyeLookDown',
    'Eye_*_Left': 'eyeLookOut|eyeLookIn',
    'Eye_*_Right': 'eyeLookIn|eyeLookOut',
    'Eye_*_Look_In': 'eyeLookIn',
    'Eye_*_Look_Out': 'eyeLookOut',
    Mouth_Sad: 'mouthFrown',
    Mouth_Pout: 'mouthPucker',
    'Mouth_Upper_Up*': 'mouthUpperUp',
    'Mouth_Lower_Down*': 'mouthLowerDown',
    Mouth_Upper_Inside: 'mouthRollUpper',
    Mouth_Lower_Inside: 'mouthRollLower',
    Mouth_Lower_Overlay: 'mouthShrugLower',
    Mouth_Ape_Shape: 'mouthClose',
    Tongue_LongStep1: 'tongueOut',
  },
  parts: {
    Mouth_Upper_Overturn: 'mouthFunnel',
    Mouth_Lower_Overturn: 'mouthFunnel',
  },
  like: {
    Eye_Frown: 'browDown',
    Mouth_O_Shape: 'mouthFunnel',
    Mouth_Upper_Left: 'mouthLeft',
    Mouth_Lower_Left: 'mouthLeft',
    Mouth_Upper_Right: 'mouthRight',
    Mouth_Lower_Right: 'mouthRight',
  },
  other: [
    'Eye_*_Dilation',
    'Eye_*_Constrict',
    'Tongue_LongStep2',
    'Tongue_UpLeft',
    'Tongue_UpRight',
    'Tongue_DownLeft',
    'Tongue_DownRight',
  ],
}

import type { RigNames } from '../rig-names.ts'

/** Blendshape names of VRoid Studio: `Fcl_BRW_...` for brows, `Fcl_EYE_...` for eyes and `Fcl_MTH_...` for the mouth. */
export const VROID: RigNames = {
  source: 'https://vroid.pixiv.help/hc/en-us/articles/41131955805977',
  like: {
    Fcl_BRW_Surprised: 'browInnerUp browOuterUp',
    Fcl_BRW_Sorrow: 'browInnerUp',
    Fcl_BRW_Fun: 'browInnerUp browOuterUp',
    Fcl_BRW_Angry: 'browDown',
    Fcl_EYE_Joy: 'eyeSquint cheekSquint',
    Fcl_EYE_Fun: 'eyeSquint cheekSquint',
    Fcl_EYE_Spread: 'eyeWide',
    Fcl_EYE_Surprised: 'eyeWide',
    Fcl_MTH_Fun: 'mouthSmile',
    Fcl_MTH_Joy: 'mouthSmile',
    Fcl_MTH_Up: 'mouthSmile',
    Fcl_MTH_Sorrow: 'mouthFrown',
    Fcl_MTH_Angry: 'mouthFrown',
    Fcl_MTH_Down: 'mouthFrown',
    Fcl_MTH_Large: 'mouthStretch',
    Fcl_MTH_Small: 'mouthPucker',
  },
  other: [
    'Fcl_BRW_Joy',
    'Fcl_EYE_Angry',
    'Fcl_EYE_Sorrow',
    'Fcl_EYE_Natural',
    'Fcl_EYE_Highlight_Hide',
    'Fcl_EYE_Iris_Hide',
    'Fcl_MTH_Neutral',
    'Fcl_MTH_SkinFung',
    'Fcl_ALL_Neutral',
    'Fcl_HA_Hide',
  ],
}

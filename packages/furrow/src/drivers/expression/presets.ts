import type { Expression } from './expression.ts'

/** Returns the same weight for the left and the right half of a blendshape or area. */
export const both = (name: string, weight = 1) => ({ [`${name}Left`]: weight, [`${name}Right`]: weight })

/** Preset expressions. They use ARKit blendshapes, and the area names of the faces that ship with Furrow. `neutral` comes first. */
export const EXPRESSIONS: readonly Expression[] = [
  { name: 'neutral', targets: {}, activations: {} },
  {
    name: 'surprised',
    targets: { browInnerUp: 1, ...both('browOuterUp'), ...both('eyeWide', 0.8), jawOpen: 0.25 },
    activations: both('forehead'),
  },
  {
    name: 'angry',
    targets: {
      ...both('browDown'),
      ...both('eyeSquint', 0.4),
      ...both('noseSneer', 0.35),
      ...both('mouthPress', 0.6),
    },
    activations: { glabella: 1, nose: 0.35, ...both('nasolabial', 0.25), ...both('underEye', 0.2) },
  },
  {
    name: 'happy',
    // In this smile, the upper teeth are visible.
    targets: {
      ...both('mouthSmile', 0.8),
      ...both('mouthUpperUp', 0.6),
      ...both('mouthLowerDown', 0.2),
      ...both('cheekSquint', 0.8),
      ...both('eyeSquint', 0.4),
      jawOpen: 0.12,
    },
    activations: { ...both('crowsFeet'), ...both('nasolabial', 0.9), ...both('underEye', 0.9) },
  },
  {
    name: 'disgusted',
    targets: {
      ...both('noseSneer'),
      ...both('mouthUpperUp', 0.6),
      ...both('browDown', 0.6),
      ...both('eyeSquint', 0.5),
    },
    activations: {
      nose: 1,
      glabella: 0.5,
      ...both('nasolabial', 0.8),
      ...both('crowsFeet', 0.3),
      ...both('underEye', 0.5),
    },
  },
  {
    name: 'sad',
    targets: {
      browInnerUp: 0.9,
      ...both('mouthFrown', 0.9),
      mouthShrugLower: 0.4,
      ...both('eyeLookDown', 0.3),
    },
    activations: { ...both('forehead', 0.5), glabella: 0.6, ...both('nasolabial', 0.4) },
  },
  {
    name: 'leftBrow',
    targets: { browOuterUpLeft: 1, browInnerUp: 0.25 },
    activations: { foreheadLeft: 1 },
  },
  {
    name: 'rightBrow',
    targets: { browOuterUpRight: 1, browInnerUp: 0.25 },
    activations: { foreheadRight: 1 },
  },
  {
    name: 'leftWink',
    targets: { eyeBlinkLeft: 0.9, cheekSquintLeft: 0.7, mouthSmileLeft: 0.35 },
    activations: { crowsFeetLeft: 1, underEyeLeft: 0.5 },
  },
  {
    name: 'rightWink',
    targets: { eyeBlinkRight: 0.9, cheekSquintRight: 0.7, mouthSmileRight: 0.35 },
    activations: { crowsFeetRight: 1, underEyeRight: 0.5 },
  },
]

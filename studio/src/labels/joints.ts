import { boneNameOf } from 'furrow/internal'
import { displayName } from '../display-name.ts'

/** Poses of joints below the face. */
export const POSES = {
  title: 'Poses',
  rest: 'Rest pose',
  skeleton: 'Skeleton',
  skeletonHint: 'Drag a dot to turn its bone, or press ← and →.',
} as const

/** Everyday names of poses, by their names. Other poses bend the part of the body that they name. */
const POSE_NAMES: Readonly<Record<string, string>> = {
  rest: POSES.rest,
  fist: 'Fist',
  'left fist': 'Left fist',
  'right fist': 'Right fist',
  'neck forward': 'Look down',
  'neck back': 'Look up',
  'neck turn to the left': 'Turn head left',
  'neck turn to the right': 'Turn head right',
  'neck tilt to the left': 'Tilt head left',
  'neck tilt to the right': 'Tilt head right',
  'waist forward': 'Bend forward',
  'waist turn to the left': 'Turn left',
  'waist turn to the right': 'Turn right',
  'waist tilt to the left': 'Lean left',
  'waist tilt to the right': 'Lean right',
}

/** Returns the everyday name of a pose of joints: `Bend left elbow` for `left elbow`. */
export function poseLabel(name: string): string {
  return POSE_NAMES[name] ?? `Bend ${displayName(name.replace(/ bend (\d+)$/, ', $1')).toLowerCase()}`
}

/** Name of an area that joints fold, as `autoWrinkles` assigns it: a joint and a movement. */
const JOINT_AREA =
  /^(.+) (flexion|extension|back|forward|(?:distal|proximal|thenar) crease|knuckles|(?:turn|tilt) to the (?:left|right)|bend \d+)$/

/** Everyday names of the skin around joints. */
const PARTS = {
  head: 'Neck',
  neck: 'Neck',
  hand: 'Wrist',
  upperArm: 'Upper arm',
  thigh: 'Thigh',
  elbow: 'Elbow',
  knee: 'Knee',
  thumb: 'Thumb',
  index: 'Index finger',
  middle: 'Middle finger',
  ring: 'Ring finger',
  little: 'Little finger',
} as const

/** Everyday names of the sides of a joint, by the movement that folds them. */
const PLACES: Readonly<Record<string, string>> = {
  flexion: 'inside',
  extension: 'outside',
  forward: 'front',
}

/** Names of the joints of the trunk. */
const TRUNK = /spine|waist|chest/i

/** Joints of a finger by words in their names. */
const PHALANGES = ['proximal', 'intermediate', 'distal']

/** Returns the everyday name of a joint: `Index finger 2, left`. */
export function jointLabel(name: string): string {
  const bone = boneNameOf(name)
  if (!bone || bone.part === 'neck' || bone.part === 'head') return displayName(name)
  return `${partOf(bone.part, name)}${bone.side ? `, ${bone.side}` : ''}`
}

/** Returns the everyday name of a region that joints fold: `Elbow: inside, left`. Returns undefined for other regions. */
export function jointRegionLabel(name: string): string | undefined {
  const [, joint, movement] = JOINT_AREA.exec(name) ?? []
  if (joint === undefined) return undefined
  const bone = boneNameOf(joint)
  const place = PLACES[movement] ?? movement
  if (!bone) return `${TRUNK.test(joint) ? 'Waist' : displayName(joint)}: ${place}`
  const side = bone.side ? `, ${bone.side}` : ''
  if (movement === 'knuckles') return `Knuckles${side}`
  if (movement.endsWith('crease')) return `Palm: ${movement}${side}`
  return `${partOf(bone.part, joint)}: ${place}${side}`
}

/** Returns the name of a part, and the number of the joint if it is a finger. */
function partOf(part: keyof typeof PARTS, joint: string): string {
  const isFinger = part === 'thumb' || PARTS[part].endsWith('finger')
  return isFinger ? `${PARTS[part]} ${phalanxOf(joint)}` : PARTS[part]
}

/** Returns the number of a finger joint from the palm on, by its name. */
function phalanxOf(joint: string): string {
  const word = PHALANGES.findIndex((each) => joint.toLowerCase().includes(each))
  return word >= 0 ? `${word + 1}` : (joint.match(/(\d+)\D*$/)?.[1] ?? '').replace(/^0+/, '')
}

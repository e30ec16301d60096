import type { SkinJoint, SkinSkeleton } from 'furrow/author'
import { Euler, Matrix4, Quaternion, Vector3 } from 'three'

/** Joint of a rig: name, parent, and position in metres in a T pose, for the person's left side. */
type Bone = [part: string, parent: string, position: [x: number, y: number, z: number]]

const FINGER_ROOTS = {
  thumb: [0.72, 1.385, 0.03],
  index: [0.79, 1.4, 0.03],
  middle: [0.795, 1.402, 0.01],
  ring: [0.79, 1.4, -0.01],
  little: [0.78, 1.395, -0.03],
} as const
const SEGMENTS = { thumb: 0.032, index: 0.028, middle: 0.031, ring: 0.028, little: 0.022 } as const
export const FINGERS = Object.keys(FINGER_ROOTS) as (keyof typeof FINGER_ROOTS)[]

/** Fingers in a T pose: palms down, thumbs forwards. */
const HAND: Bone[] = FINGERS.flatMap((finger) => {
  const [x, y, z] = FINGER_ROOTS[finger]
  const step = SEGMENTS[finger]
  const [across, down, front] = finger === 'thumb' ? [0.75, -0.2, 0.63] : [1, -0.05, 0]
  return [0, 1, 2].map(
    (k): Bone => [
      `${finger}${k + 1}`,
      k === 0 ? 'hand' : `${finger}${k}`,
      [x + k * step * across, y + k * step * down, z + k * step * front],
    ],
  )
})

const SIDED: Bone[] = [
  ['shoulder', 'chest', [0.05, 1.42, 0]],
  ['upperArm', 'shoulder', [0.18, 1.4, 0]],
  ['lowerArm', 'upperArm', [0.45, 1.4, 0]],
  ['hand', 'lowerArm', [0.7, 1.4, 0]],
  ...HAND,
  ['upperLeg', 'hips', [0.1, 0.95, 0]],
  ['lowerLeg', 'upperLeg', [0.1, 0.5, 0]],
  ['foot', 'lowerLeg', [0.1, 0.08, 0]],
  ['toes', 'foot', [0.1, 0.02, 0.12]],
]

const MIDDLE: Bone[] = [
  ['hips', '', [0, 1, 0]],
  ['spine', 'hips', [0, 1.1, 0]],
  ['chest', 'spine', [0, 1.25, 0]],
  ['neck', 'chest', [0, 1.45, 0]],
  ['head', 'neck', [0, 1.56, 0.02]],
]

/** Names of a rig, from its public documentation. `name` returns undefined for joints that the rig does not have. */
export interface Rig {
  name(part: string, side: '' | 'left' | 'right'): string | undefined
  /** Joints that the rig has in addition: part, parent and position, for the left side or the middle. */
  extra?: Bone[]
}

const ORDER = ['thumb', 'index', 'middle', 'ring', 'little']
const isFinger = /^(thumb|index|middle|ring|little)(\d)$/
const title = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

function mixamo(prefix: string): Rig['name'] {
  const names: Record<string, string> = {
    hips: 'Hips',
    spine: 'Spine',
    chest: 'Spine2',
    neck: 'Neck',
    head: 'Head',
    shoulder: 'Shoulder',
    upperArm: 'Arm',
    lowerArm: 'ForeArm',
    hand: 'Hand',
    upperLeg: 'UpLeg',
    lowerLeg: 'Leg',
    foot: 'Foot',
    toes: 'ToeBase',
  }
  return (part, side) => {
    const finger = isFinger.exec(part)
    const own = finger ? `Hand${title(finger[1]!.replace('little', 'pinky'))}${finger[2]}` : names[part]
    return own && `${prefix}${title(side)}${own}`
  }
}

const PHALANGES = ['Proximal', 'Intermediate', 'Distal']
const THUMB = ['Metacarpal', 'Proximal', 'Distal']

export const RIGS: Record<string, Rig> = {
  'VRM 1': {
    name: (part, side) => {
      const finger = isFinger.exec(part)
      const own = finger
        ? title(finger[1]!) + (finger[1] === 'thumb' ? THUMB : PHALANGES)[Number(finger[2]) - 1]
        : title(part)
      return side === '' ? part : side + own
    },
  },
  VRoid: {
    name: (part, side) =>
      `J_Bip_${side === '' ? 'C' : title(side).charAt(0)}_${title(part)}`.replace(/_Toes$/, '_ToeBase'),
    extra: [['hairJoint', 'head', [0, 1.7, 0]]],
  },
  Mixamo: { name: mixamo('mixamorig:'), extra: [['index4', 'index3', [0.9, 1.39, 0.03]]] },
  'Ready Player Me': { name: mixamo('') },
  Rigify: {
    name: (part, side) => {
      const spine: Record<string, string> = {
        hips: 'spine',
        spine: 'spine.001',
        chest: 'spine.003',
        neck: 'spine.004',
        head: 'spine.006',
      }
      const limbs: Record<string, string> = {
        upperArm: 'upper_arm',
        lowerArm: 'forearm',
        upperLeg: 'thigh',
        lowerLeg: 'shin',
        toes: 'toe',
      }
      if (side === '') return `DEF-${spine[part]}`
      const finger = isFinger.exec(part)
      const own = finger
        ? `${finger[1] === 'thumb' ? '' : 'f_'}${finger[1]!.replace('little', 'pinky')}.0${finger[2]}`
        : (limbs[part] ?? part)
      return `DEF-${own}.${title(side).charAt(0)}`
    },
  },
  Unreal: {
    name: (part, side) => {
      const names: Record<string, string> = {
        hips: 'pelvis',
        spine: 'spine_01',
        chest: 'spine_03',
        neck: 'neck_01',
        shoulder: 'clavicle',
        upperArm: 'upperarm',
        lowerArm: 'lowerarm',
        upperLeg: 'thigh',
        lowerLeg: 'calf',
        toes: 'ball',
      }
      const finger = isFinger.exec(part)
      const own = finger ? `${finger[1]!.replace('little', 'pinky')}_0${finger[2]}` : (names[part] ?? part)
      return side === '' ? own : `${own}_${side.charAt(0)}`
    },
    extra: [['lowerarm_twist_01', 'lowerArm', [0.55, 1.4, 0]]],
  },
  MakeHuman: {
    name: (part, side) => {
      const names: Record<string, string> = {
        hips: 'root',
        spine: 'spine05',
        chest: 'spine01',
        neck: 'neck01',
        upperArm: 'upperarm01',
        lowerArm: 'lowerarm01',
        hand: 'wrist',
        upperLeg: 'upperleg01',
        lowerLeg: 'lowerleg01',
        toes: 'toe1-1',
      }
      const finger = isFinger.exec(part)
      const own = finger ? `finger${ORDER.indexOf(finger[1]!) + 1}-${finger[2]}` : (names[part] ?? part)
      return side === '' ? own : `${own}.${title(side).charAt(0)}`
    },
  },
  'Character Creator': {
    name: (part, side) => {
      const names: Record<string, string> = {
        hips: 'Hip',
        spine: 'Waist',
        chest: 'Spine02',
        neck: 'NeckTwist01',
        head: 'Head',
        shoulder: 'Clavicle',
        upperArm: 'Upperarm',
        lowerArm: 'Forearm',
        hand: 'Hand',
        upperLeg: 'Thigh',
        lowerLeg: 'Calf',
        foot: 'Foot',
        toes: 'ToeBase',
      }
      const finger = isFinger.exec(part)
      const own = finger
        ? `${title(finger[1]!.replace('little', 'pinky').replace('middle', 'mid'))}${finger[2]}`
        : names[part]
      return `CC_Base_${side === '' ? '' : `${title(side).charAt(0)}_`}${own}`
    },
  },
}

/** Joints that move twisted skin, a skirt and hair. */
export const TWISTS: Bone[] = [
  ['upperArmTwist', 'upperArm', [0.3, 1.4, 0]],
  ['lowerArmTwist', 'lowerArm', [0.58, 1.4, 0]],
  ['upperLegTwist', 'upperLeg', [0.1, 0.7, 0]],
]
export const SKIRTS: Bone[] = [
  ['skirt1', 'hips', [0.15, 0.9, 0.1]],
  ['skirt2', 'skirt1', [0.18, 0.7, 0.12]],
  ['skirt3', 'skirt2', [0.2, 0.4, 0.14]],
]
export const PIGTAILS: Bone[] = [
  ['pigtail1', 'head', [0.1, 1.65, -0.05]],
  ['pigtail2', 'pigtail1', [0.18, 1.3, -0.08]],
  ['pigtail3', 'pigtail2', [0.19, 0.8, -0.1]],
]

export interface SkeletonOptions {
  /** Turns the arms down by these degrees: 0 for a T pose, 45 for an A pose. */
  armsDown?: number
  /** Whether each joint has arbitrary axes in the bind pose. */
  turned?: boolean
  scale?: number
  /** Whether the hands have fingers; default: true. */
  fingers?: boolean
  rename?: (name: string, index: number) => string
}

/** Builds the skeleton of a person. Each joint moves one vertex, except those that only a rig has. */
export function skeletonOf(
  { name, extra = [] }: Rig,
  { armsDown = 0, turned = false, scale = 1, fingers = true, rename = (own) => own }: SkeletonOptions = {},
): SkinSkeleton {
  const joints: (SkinJoint & { part: string })[] = []
  const add = (part: string, parent: string, at: readonly number[], side: '' | 'left' | 'right') => {
    const own = name(part, side) ?? part
    const index = joints.findIndex((joint) => joint.part === parent)
    const shoulder = new Vector3(0.18, 1.4, 0)
    const place = new Vector3(...at)
    if (place.x > 0.19) {
      const down = new Quaternion().setFromEuler(new Euler(0, 0, (-armsDown * Math.PI) / 180))
      place.sub(shoulder).applyQuaternion(down).add(shoulder)
    }
    if (side === 'right') place.x *= -1
    const axes = turned ? new Euler(joints.length, 2 * joints.length, 3 * joints.length) : new Euler()
    const bind = new Matrix4().makeRotationFromEuler(axes).setPosition(place.multiplyScalar(scale))
    joints.push({ name: own, parent: index, bind: bind.toArray(), part: `${part}${side}` })
  }
  for (const [part, parent, at] of MIDDLE) add(part, parent, at, '')
  const isMiddle = (part: string) => part === '' || MIDDLE.some(([own]) => own === part)
  const sided = [...SIDED, ...extra].filter((bone) => fingers || !HAND.includes(bone))
  for (const side of ['left', 'right'] as const)
    for (const [part, parent, at] of sided)
      add(part, isMiddle(parent) ? parent : `${parent}${side}`, at, side)
  return {
    joints: joints.map(({ part, ...joint }, i) => ({ ...joint, name: rename(joint.name, i) })),
    influences: 1,
    indices: joints.map((_, i) => i),
    weights: joints.map(({ part }) => (extra.some(([own]) => part.startsWith(own)) ? 0 : 1)),
  }
}

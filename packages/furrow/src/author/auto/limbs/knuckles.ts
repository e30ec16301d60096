import type { BoneDriver } from '../../../drivers/bone/definition.ts'
import { add, scale, type Vector } from '../../../math/vector3.ts'
import type { Finger } from '../skeleton/bone-names.ts'
import type { HandJoints } from '../skeleton/humanoid.ts'
import { fingerBones, flexion, type HandFrame } from './hand-frame.ts'
import { jointDriver } from './joint-driver.ts'
import type { LimbSkin } from './limb-skin.ts'

/** Knuckles of a hand. They turn pale in a fist. */
export interface Knuckles {
  /** Name of the area. */
  name: string
  /** Positions on the skin, in the coordinates of the surface. */
  places: readonly Vector[]
  /** Distance in millimetres at which the paleness ends. */
  radius: number
  driver: BoneDriver
}

/** Fingers whose knuckles stand out in a fist. */
const PRESSED: readonly Finger[] = ['index', 'middle', 'ring', 'little']
/** Distance from a joint to the skin on its back, and radius of the pale spot, in millimetres for an adult. */
const TO_SKIN = 8
const RADIUS = 11
/** Angle of the middle joint of a finger in a tight fist, in degrees. */
const FIST = 90

/** Returns the knuckles of a hand; undefined if a finger has only one joint. */
export function knucklesOf(
  limb: LimbSkin,
  { wrist, fingers }: HandJoints,
  frame: HandFrame,
): Knuckles | undefined {
  const size = frame.size.along
  const bones = PRESSED.flatMap((finger) => {
    const joints = fingers.get(finger)
    return joints && joints.length > 2 ? [fingerBones(limb, frame, finger, joints)] : []
  })
  const own = bones[Math.min(1, bones.length - 1)]
  if (!own) return undefined
  const name = `${limb.skeleton.joints[wrist].name} knuckles`
  const turn = flexion(limb, own[1], FIST)
  const driver = jointDriver(limb, name, { turn, rest: 0, full: 1 })
  return {
    name,
    places: bones.map(([{ place, inside }]) => add(place, scale(inside, -TO_SKIN * size))),
    radius: RADIUS * size,
    // The blood leaves the skin only when the fist is nearly closed.
    driver: {
      ...driver,
      curve: [
        [0.4 * turn.full, 0],
        [turn.full, 1],
      ],
    },
  }
}

/** Poses the shipped hand by the joints of WebXR, for hand-tracking.html. Not part of the library. */

import { Quaternion, Vector3 } from 'three'

/**
 * Joint of WebXR for each bone of the hand, parents first. The bones of the palm keep their pose (null), because they fan
 * out differently than those of a person.
 */
const JOINTS = {
  ...Object.fromEntries([1, 2, 3, 4].map((i) => [`metacarpal${i}L`, null])),
  'finger1-1L': 'thumb-metacarpal',
  'finger1-2L': 'thumb-phalanx-proximal',
  'finger1-3L': 'thumb-phalanx-distal',
  ...Object.fromEntries(
    ['index', 'middle', 'ring', 'pinky'].flatMap((finger, i) =>
      ['proximal', 'intermediate', 'distal'].map((bone, k) => [
        `finger${i + 2}-${k + 1}L`,
        `${finger}-finger-phalanx-${bone}`,
      ]),
    ),
  ),
}

/**
 * Rotation from a joint of WebXR to a bone. In WebXR, -z points along the bone and y out of the back of the hand. In the
 * shipped hand, y points along the bone and z out of the palm.
 * https://immersive-web.github.io/webxr-hand-input/#skeleton-joints-section
 */
const TO_BONE = new Quaternion(0, Math.SQRT1_2, -Math.SQRT1_2, 0)

/**
 * Returns a function that poses a hand. Its argument has the joints of three.js's `renderer.xr.getHand(i).joints`, with
 * `position`, `quaternion` and `visible`. The bones keep their lengths, so the hand keeps its size.
 *
 * @param hand scene of faces/hand.glb, without a rotated or moved parent.
 */
export function handPoser(hand) {
  hand.updateMatrixWorld(true)
  const wrist = { bone: hand.getObjectByName('wristL'), world: new Quaternion() }
  const bones = [wrist]
  for (const [name, joint] of Object.entries(JOINTS)) {
    const bone = hand.getObjectByName(name)
    const parent = bones.find((each) => each.bone === bone.parent)
    bones.push({ bone, joint, parent, world: new Quaternion() })
  }
  const rest = wrist.bone.getWorldQuaternion(new Quaternion()).invert()
  const place = hand.worldToLocal(wrist.bone.getWorldPosition(new Vector3()))
  return (joints) => {
    if (!joints.wrist?.visible) return
    wrist.world.copy(joints.wrist.quaternion).multiply(TO_BONE)
    hand.quaternion.copy(wrist.world).multiply(rest)
    hand.position.copy(place).applyQuaternion(hand.quaternion).negate().add(joints.wrist.position)
    for (const { bone, joint, parent, world } of bones) {
      if (!parent) continue
      if (joints[joint]?.visible) {
        world.copy(joints[joint].quaternion).multiply(TO_BONE)
        bone.quaternion.copy(parent.world).invert().multiply(world)
      } else world.copy(parent.world).multiply(bone.quaternion)
    }
  }
}

const X = new Vector3(1, 0, 0)
const Y = new Vector3(0, 1, 0)
const Z = new Vector3(0, 0, 1)

/** Bends of the joints of a finger and of the thumb, radians, in an open hand and in a fist. */
const BENDS = {
  finger: { open: [0.24, 0.22, 0.12], fist: [1.35, 1.6, 1] },
  thumb: { open: [0, 0.2, 0.2], fist: [-0.1, 0.45, 0.8] },
}

/**
 * Simulates the joints of a left hand whose fingers point up and whose palm faces the viewer.
 *
 * @param fist 0 for an open hand, 1 for a fist.
 * @param position place of the wrist.
 */
export function simulatedJoints(fist, position) {
  const wrist = TO_BONE.clone().premultiply(new Quaternion().setFromAxisAngle(Y, -0.3))
  const joints = { wrist: { position, quaternion: wrist, visible: true } }
  const add = (names, start, { open, fist: closed }) => {
    const quaternion = start.clone()
    for (const [i, name] of names.entries()) {
      quaternion.multiply(new Quaternion().setFromAxisAngle(X, -(open[i] + (closed[i] - open[i]) * fist)))
      joints[name] = { quaternion: quaternion.clone(), visible: true }
    }
  }
  for (const [i, finger] of ['index', 'middle', 'ring', 'pinky'].entries()) {
    const spread = new Quaternion().setFromAxisAngle(Y, (1 - fist) * 0.1 * (i - 1))
    const start = wrist.clone().multiply(spread)
    joints[`${finger}-finger-metacarpal`] = { quaternion: start, visible: true }
    const names = ['proximal', 'intermediate', 'distal'].map((bone) => `${finger}-finger-phalanx-${bone}`)
    add(names, start, BENDS.finger)
  }
  // The thumb stays beside the fist.
  const thumb = wrist
    .clone()
    .multiply(new Quaternion().setFromAxisAngle(Z, -0.5 * fist))
    .multiply(new Quaternion().setFromAxisAngle(Y, -0.8))
    .multiply(new Quaternion().setFromAxisAngle(Z, -Math.PI / 2))
  add(['thumb-metacarpal', 'thumb-phalanx-proximal', 'thumb-phalanx-distal'], thumb, BENDS.thumb)
  return joints
}

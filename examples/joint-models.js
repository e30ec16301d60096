/** Places and moves the models of joints.html, a hand and a neck. Not part of the library. */

import { AnimationMixer, AnimationUtils, Group, Matrix4, Vector3 } from 'three'

/**
 * Start and end of the motion in each clip, seconds. The clip `turn` has a second range, in which the head turns to the
 * other side.
 */
const RANGES = {
  fist: [[0, 1.4]],
  turn: [
    [0, 1.2],
    [2.8, 4],
  ],
  nod: [[0, 1]],
}

/**
 * Places a model in front of the camera of `showFace`. Returns a group that contains the model. Rotate this group to
 * turn the model.
 */
export function placeModel(scene, model) {
  const pivot = new Group().add(scene)
  if (model === 'hand') poseHand(pivot, scene)
  else pivot.position.set(0, 0.03, 0.24)
  return pivot
}

/** Turns the hand so that its fingers point up and its palm faces the camera. */
function poseHand(pivot, scene) {
  scene.updateMatrixWorld(true)
  const wrist = scene.getObjectByName('wristL').getWorldPosition(new Vector3())
  const knuckle = scene.getObjectByName('finger3-1L')
  const middle = knuckle.getWorldPosition(new Vector3())
  const up = middle.clone().sub(wrist).normalize()
  const right = up.clone().cross(new Vector3().setFromMatrixColumn(knuckle.matrixWorld, 2)).normalize()
  const basis = new Matrix4().makeBasis(right, up, right.clone().cross(up))
  scene.quaternion.setFromRotationMatrix(basis.invert())
  scene.position.copy(middle).applyQuaternion(scene.quaternion).negate()
  pivot.position.set(0, 0.76, 0.3)
}

/**
 * Returns `name`, `min` and `move` for each clip of a model. `move` poses the model. Its argument is 0 for the pose at
 * rest and 1 for the end of the motion. If `min` is -1, -1 is the end of the motion to the other side. The clips are
 * additive, so the head can turn and nod at the same time.
 */
export function clipMovers(scene, animations) {
  const mixer = new AnimationMixer(scene)
  return animations.map((clip) => {
    const ranges = RANGES[clip.name]
    const action = mixer.clipAction(AnimationUtils.makeClipAdditive(clip)).play()
    action.paused = true
    const move = (value) => {
      const [from, to] = value < 0 ? ranges[1] : ranges[0]
      action.time = from + (to - from) * Math.abs(value)
      mixer.update(0)
    }
    return { name: clip.name, min: ranges.length > 1 ? -1 : 0, move }
  })
}

import { AUTO_REGIONS } from 'furrow/author'
import { expect, it, test } from 'vitest'
import { BOTH_SIDES, CENTRAL } from '../../../packages/furrow/src/drivers/morph/aliases.ts'
import { displayName } from '../../../studio/src/display-name.ts'
import { poseLabel } from '../../../studio/src/labels/joints.ts'
import { blendshapeLabel, regionLabel, regionName } from '../../../studio/src/labels/names.ts'

test.each([
  ['foreheadInnerLeft', 'Inner forehead, left'],
  ['crowsFeetRight', 'Crow’s feet, right'],
  ['chin', 'Chin'],
  ['flushCheeks', 'Redness: cheeks'],
  ['my_area2', 'My area 2'],
  ['Left', 'Left'],
  ['LeftForeArm flexion', 'Elbow: inside, left'],
  ['finger2-3.L back', 'Index finger 3: back, left'],
  ['J_Bip_R_Ring2 flexion', 'Ring finger 2: inside, right'],
  ['wrist.R thenar crease', 'Palm: thenar crease, right'],
  ['head turn to the left', 'Neck: turn to the left'],
  ['Bone_12 bend 2', 'Bone 12: bend 2'],
])('%s is called %s', (name, label) => {
  expect(regionLabel(name)).toBe(label)
})

test.each([
  ['left elbow', 'Bend left elbow'],
  ['left fist', 'Left fist'],
  ['neck forward', 'Look down'],
  ['tail3 bend 1', 'Bend tail 3, 1'],
])('the pose %s is called %s', (name, label) => {
  expect(poseLabel(name)).toBe(label)
})

test.each([
  ['browDownLeft', 'Brow lowered, left'],
  ['browInnerUp', 'Inner brows raised'],
  ['jawLeft', 'Jaw to the left'],
  ['Fcl_ALL_Joy', 'Fcl all joy'],
])('the blendshape %s is called %s', (name, label) => {
  expect(blendshapeLabel(name)).toBe(label)
})

it('blendshapes of ARKit have different everyday names', () => {
  const names = [...CENTRAL, ...BOTH_SIDES.flatMap((name) => [`${name}Left`, `${name}Right`])]
  const labels = names.map(blendshapeLabel)
  expect(new Set(labels).size).toBe(52)
  // Names without an entry in the table keep the words of the file.
  const kept = names.filter((name, i) => labels[i] === displayName(name))
  expect(kept).toEqual(['jawForward', 'jawOpen', 'tongueOut'])
})

it('automatic regions have different names', () => {
  expect(new Set(AUTO_REGIONS.map(regionName)).size).toBe(AUTO_REGIONS.length)
})

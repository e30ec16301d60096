import { parseDrivers } from 'furrow'
import { BENT } from 'furrow/internal'
import { Bone, Group, type Object3D, Quaternion, Skeleton, SkinnedMesh, Vector3 } from 'three'
import { expect, it } from 'vitest'
import { type BodyPose, bodyPoses, jointsOfArea } from '../../../../studio/src/viewer/pose/body-poses.ts'
import { REST_POSE, SkeletonPose } from '../../../../studio/src/viewer/pose/skeleton-pose.ts'
import { shippedSkin } from '../../author/auto/limbs/models.ts'
import { sleeve } from '../../author/auto/limbs/sleeve.ts'

const FULL = 2
const WEIGHTS = { width: 2, height: 2, data: new Uint8Array(4).fill(255) }

function driverOf(area: string, joint: string, [first, last]: [number, number] = [0, 1]) {
  const curve = [
    [0, first],
    [FULL, last],
  ]
  return { type: 'bone', area, joints: ['Spine', joint], measure: 'angle', axis: [0, 0, 1], curve }
}

function posesOf(skin: ReturnType<typeof sleeve>, ...drivers: ReturnType<typeof driverOf>[]) {
  const areas = drivers.map(({ area }) => area)
  return bodyPoses(skin, parseDrivers(drivers, areas), new Map(areas.map((area) => [area, WEIGHTS])))
}

it('areas that one joint folds share a pose with its name, and areas that bending smooths have none', () => {
  const poses = posesOf(
    sleeve(),
    driverOf('LeftForeArm flexion', 'LeftForeArm'),
    driverOf('crook', 'LeftForeArm'),
    driverOf('LeftForeArm extension', 'LeftForeArm', [1, 0]),
  )
  expect(poses.map(({ name, areas }) => [name, areas])).toEqual([
    ['left elbow', ['LeftForeArm flexion', 'crook']],
  ])
  expect(poses[0]!.place().size).toBeGreaterThan(0)
})

it('all fingers of a hand make a fist, and its wrist bends both ways', async () => {
  const skin = await shippedSkin('hand')
  const poses = posesOf(
    skin as ReturnType<typeof sleeve>,
    driverOf('finger2-1.L flexion', 'finger2-1.L'),
    driverOf('finger5-3.L flexion', 'finger5-3.L'),
    driverOf('wrist.L flexion', 'wrist.L'),
    driverOf('wrist.L extension', 'wrist.L'),
  )
  expect(poses.map(({ name }) => name)).toEqual(['left fist', 'left wrist', 'left wrist back'])
})

it('the joints between those of a driver share its angle in the pose of an area', () => {
  const drivers = parseDrivers([driverOf('crook', 'LeftForeArm')], ['crook'])
  const turns = jointsOfArea(sleeve(), drivers, 'crook', BENT)
  expect([...turns.keys()]).toEqual(['LeftArm', 'LeftForeArm'])
  for (const [, , z, w] of turns.values()) expect(2 * Math.atan2(z, w)).toBeCloseTo((BENT * FULL) / 2)
})

/** Returns an arm whose joint `elbow` is turned at rest, with two poses that turn it. */
function arm() {
  const [upper, elbow] = [new Bone(), new Bone()]
  upper.name = 'upper'
  elbow.name = 'elbow'
  elbow.quaternion.setFromAxisAngle(new Vector3(1, 0, 0), 0.5)
  upper.add(elbow)
  const mesh = new SkinnedMesh()
  const root = new Group().add(upper, mesh)
  mesh.bind(new Skeleton([upper, elbow]))
  const rest = new Map<Object3D, Quaternion>([upper, elbow].map((bone) => [bone, bone.quaternion.clone()]))
  const skeleton = new SkeletonPose(root, rest)
  const about = (angle: number) => [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)] as const
  skeleton.poses = [
    { name: 'bend', joints: new Map([['elbow', about(1)]]) },
    { name: 'both', joints: new Map([['upper', about(1)]]) },
  ] as unknown as BodyPose[]
  const angleOf = (bone: Bone) => bone.quaternion.angleTo(rest.get(bone)!)
  return { skeleton, upper, elbow, angleOf }
}

it('a pose button turns its joints part of the way, replaces other poses, and the rest pose restores all', () => {
  const { skeleton, upper, elbow, angleOf } = arm()
  skeleton.play('bend', 0)
  expect(skeleton.amountOf('bend')).toBe(BENT)
  expect(angleOf(elbow)).toBeCloseTo(BENT)
  skeleton.play('both', 0)
  expect(skeleton.amountOf('bend')).toBe(0)
  expect(angleOf(elbow)).toBeCloseTo(0)
  expect(angleOf(upper)).toBeCloseTo(BENT)
  skeleton.play(REST_POSE, 0)
  expect(skeleton.isTurned).toBe(false)
})

it('a transition passes through the amounts between two poses', () => {
  const { skeleton, elbow, angleOf } = arm()
  skeleton.play('bend', 1)
  skeleton.advance(0.5)
  expect(skeleton.isMoving).toBe(true)
  expect(skeleton.amountOf('bend')).toBeCloseTo(BENT / 2)
  expect(angleOf(elbow)).toBeCloseTo(BENT / 2)
  skeleton.advance(Number.POSITIVE_INFINITY)
  expect([skeleton.isMoving, skeleton.amountOf('bend')]).toEqual([false, BENT])
})

it('a slider changes the amount of one pose, and keeps what was turned by hand', () => {
  const { skeleton, elbow, angleOf } = arm()
  elbow.quaternion.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), 0.3))
  skeleton.setAmount('bend', 1)
  expect(angleOf(elbow)).toBeCloseTo(1.3)
  skeleton.setAmount('bend', 0)
  expect(angleOf(elbow)).toBeCloseTo(0.3)
})

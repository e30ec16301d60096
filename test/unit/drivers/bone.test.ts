import type { BoneDriver } from 'furrow'
import { DriverProgram, JointMeasurement, measuredSource, planDrivers } from 'furrow/internal'
import { Euler, Matrix4, Quaternion, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { ramp } from '../../drivers.ts'
import { seeded } from '../../random.ts'

/** Curve from which the test can compute the measured value within -4..4. */
const RULER = ramp(-4, 4)
const measured = (activation: number) => 8 * activation - 4

const driver = (measure: BoneDriver['measure'], axis?: BoneDriver['axis']): BoneDriver => ({
  type: 'bone',
  area: 'palm',
  joints: ['hand', 'finger'],
  measure,
  ...(axis && { axis }),
  curve: RULER,
})

const joint = (position: [number, number, number], rotation: Quaternion, scale = 1) =>
  new Matrix4().compose(new Vector3(...position), rotation, new Vector3(scale, scale, scale))
const turned = (axis: [number, number, number], angle: number) =>
  new Quaternion().setFromAxisAngle(new Vector3(...axis).normalize(), angle)
const numbers = (...matrices: Matrix4[]) => matrices.flatMap(({ elements }) => elements)

const restHand = turned([1, 2, 3], 0.7)
const restFinger = turned([-1, 0.5, 2], 1.9)
const rest = numbers(joint([0, 1, 0], restHand), joint([0.1, 1, 0], restFinger))

function activate(drivers: BoneDriver[], hand: Matrix4, finger: Matrix4) {
  const plan = planDrivers(drivers)
  const joints = new JointMeasurement(plan.inputs.joint, ['hand', 'finger'], () => rest)
  const program = new DriverProgram(plan, { joint: measuredSource(joints.missing) })
  const state = program.createState()
  joints.measure(numbers(hand, finger), state.inputs.joint)
  program.evaluate(state)
  return { activation: state.activations[0], missing: program.missing }
}

function read(bone: BoneDriver, hand: Matrix4, finger: Matrix4): number {
  return measured(activate([bone], hand, finger).activation)
}

describe('bone drivers', () => {
  it.each([0, 0.3, 1.2, 2.5, 3.1])(
    'reads a turn of %d, for any axis and after moving both joints',
    (angle) => {
      const random = seeded(3)
      for (let i = 0; i < 20; i++) {
        const axis: [number, number, number] = [random() - 0.5, random() - 0.5, random() - 0.5]
        const body = turned([random(), random(), random() + 0.1], 6 * random())
        const hand = body.clone().multiply(restHand)
        const finger = body.clone().multiply(restFinger).multiply(turned(axis, angle))
        const now = read(driver('angle'), joint([5, 0, 1], hand, 2), joint([4, 4, 4], finger, 0.3))
        expect(now).toBeCloseTo(angle, 5)
      }
    },
  )

  it('reads a signed angle about an axis, without the rotation across this axis', () => {
    const about = (rotation: Quaternion) =>
      read(
        driver('angle', [0, 0, 2]),
        joint([0, 0, 0], restHand),
        joint([0, 0, 0], restFinger.clone().multiply(rotation)),
      )
    expect(about(turned([0, 0, 1], 0.8))).toBeCloseTo(0.8, 5)
    expect(about(turned([0, 0, 1], -2.2))).toBeCloseTo(-2.2, 5)
    expect(about(turned([1, 0, 0], 1.1))).toBeCloseTo(0, 5)
    // A rotation about z after one about another axis.
    expect(about(turned([1, 1, 0], 0.6).multiply(turned([0, 0, 1], 0.5)))).toBeCloseTo(0.5, 5)
  })

  it('agrees with the angle between quaternions for random turns', () => {
    const random = seeded(8)
    for (let i = 0; i < 100; i++) {
      const turn = new Quaternion().setFromEuler(new Euler(6 * random(), 3 * random(), 6 * random()))
      const now = read(
        driver('angle'),
        joint([0, 0, 0], restHand),
        joint([0, 0, 0], restFinger.clone().multiply(turn)),
      )
      expect(now).toBeCloseTo(turn.angleTo(new Quaternion()), 4)
    }
  })

  it('reads the distance of two joints in metres', () => {
    expect(
      read(driver('distance'), joint([0, 1, 2], restHand, 3), joint([0.3, 1.4, 2], restFinger)),
    ).toBeCloseTo(0.5, 5)
  })

  it('sums drivers of one area, and continues without a missing joint', () => {
    const bend = ramp(0, 1, 0.3)
    const { activation, missing } = activate(
      [
        { ...driver('distance'), curve: bend },
        { ...driver('distance'), curve: bend },
        { ...driver('angle'), joints: ['hand', 'sixthFinger'] },
      ],
      joint([0, 0, 0], restHand),
      joint([0, 1, 0], restFinger),
    )
    expect(activation).toBeCloseTo(0.6, 6)
    expect(missing).toEqual(['joint "sixthFinger" of a driver of area "palm"'])
  })
})

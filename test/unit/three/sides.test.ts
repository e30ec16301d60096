import { Bone, Object3D } from 'three'
import { expect, it } from 'vitest'
import { frontOfSides } from '../../../packages/furrow/src/three/camera/sides.ts'

/** Makes joints on both sides of a body. The positions are those of the left joints, and of the right ones if they differ. */
function bodyOf(
  joints: Record<string, readonly [left: readonly number[], right?: readonly number[]]>,
): Object3D {
  const root = new Object3D()
  for (const [name, [left, right = [-left[0], left[1], left[2]]]] of Object.entries(joints)) {
    for (const [side, position] of [
      ['Left', left],
      ['Right', right],
    ] as const) {
      const joint = new Bone()
      joint.name = side + name
      joint.position.fromArray(position)
      root.add(joint)
    }
  }
  root.updateMatrixWorld()
  return root
}

const degreesOf = (root: Object3D) => {
  const { x, z } = frontOfSides(root, [])
  return (Math.atan2(x, z) * 180) / Math.PI
}

it('a body looks perpendicular to its pairs of joints', () => {
  const body = bodyOf({ Hand: [[0.7, 1.4, 0]], Foot: [[0.1, 0, 0]] })
  expect(degreesOf(body)).toBeCloseTo(0, 5)
  body.rotation.y = 0.6
  body.updateMatrixWorld()
  expect(degreesOf(body)).toBeCloseTo((0.6 * 180) / Math.PI, 4)
})

it('a body in the middle of a step looks where its trunk does', () => {
  const body = bodyOf({
    Shoulder: [[0.2, 1.5, 0]],
    Arm: [[0.3, 1.5, 0]],
    UpLeg: [[0.1, 1, 0]],
    Hand: [
      [0.3, 1, -0.4],
      [-0.3, 1, 0.6],
    ],
    Foot: [
      [0.1, 0, 0.5],
      [-0.1, 0, -0.5],
    ],
  })
  expect(Math.abs(degreesOf(body))).toBeLessThan(1)
})

it('a body without pairs of joints has no direction', () => {
  expect(frontOfSides(bodyOf({}), []).length()).toBe(0)
  expect(frontOfSides(bodyOf({ Eye: [[0, 1, 0]] }), []).length()).toBe(0)
})

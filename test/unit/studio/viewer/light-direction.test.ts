import { Vector3 } from 'three'
import { expect, it } from 'vitest'
import {
  ballPoint,
  clampedLight,
  lightFrom,
  lightOnBall,
  lightPosition,
} from '../../../../studio/src/viewer/light-direction.ts'

it.each([
  [0, 0],
  [-46, 44],
  [90, 0],
  [30, -85],
])('a light %i to the right and %i above comes from there', (yaw, pitch) => {
  const position = lightPosition({ yaw, pitch }, new Vector3())
  expect(position.length()).toBeCloseTo(1, 9)
  expect(Math.sign(Math.round(1e6 * position.x))).toBe(Math.sign(yaw))
  expect(Math.sign(Math.round(1e6 * position.y))).toBe(Math.sign(pitch))
  expect(lightFrom(position)).toEqual({ yaw, pitch })
})

it('the ball of the light is brightest where it is touched, or at its border if the touch is outside', () => {
  for (const [x, y] of [
    [0, 0],
    [-0.5, 0.4],
    [0.6, -0.7],
  ]) {
    const [u, v] = ballPoint(lightOnBall(x, y))
    expect(u).toBeCloseTo(x, 1)
    expect(v).toBeCloseTo(y, 1)
  }
  expect(lightOnBall(5, 0)).toEqual({ yaw: 90, pitch: 0 })
})

it('a light stays in front of the face', () => {
  expect(clampedLight({ yaw: 120, pitch: -100 })).toEqual({ yaw: 90, pitch: -85 })
})

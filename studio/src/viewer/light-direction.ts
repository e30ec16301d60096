import { Vector3 } from 'three'

/** Direction from the face to the light, degrees: `yaw` to the right as seen from the camera, `pitch` upwards. */
export interface LightDirection {
  readonly yaw: number
  readonly pitch: number
}

/** Maximum yaw and pitch, degrees. A larger yaw lights the face from behind. At a pitch of 90, the direction would not depend on the yaw. */
export const MAX_LIGHT = [90, 85] as const

const RADIANS = Math.PI / 180

export function clampedLight({ yaw, pitch }: LightDirection): LightDirection {
  const clamp = (value: number, most: number) => Math.round(Math.min(most, Math.max(-most, value)))
  return { yaw: clamp(yaw, MAX_LIGHT[0]), pitch: clamp(pitch, MAX_LIGHT[1]) }
}

/** Returns the position of a light for a face that looks along +Z. */
export function lightPosition({ yaw, pitch }: LightDirection, out: Vector3): Vector3 {
  return out.setFromSphericalCoords(1, (90 - pitch) * RADIANS, yaw * RADIANS)
}

export function lightFrom({ x, y, z }: Vector3): LightDirection {
  return clampedLight({ yaw: Math.atan2(x, z) / RADIANS, pitch: Math.atan2(y, Math.hypot(x, z)) / RADIANS })
}

/**
 * Returns the direction of the light under which a point on a ball is brightest. The control for the light shows such a ball.
 *
 * @param x distance to the right of the centre, 1 at the border of the ball. Clamped to the ball.
 * @param y distance above the centre.
 */
export function lightOnBall(x: number, y: number): LightDirection {
  const length = Math.max(1, Math.hypot(x, y))
  const [u, v] = [x / length, y / length]
  return lightFrom(new Vector3(u, v, Math.sqrt(Math.max(0, 1 - u * u - v * v))))
}

/** Returns the point on the ball that is brightest under a light. This is the inverse of `lightOnBall`. */
export function ballPoint(light: LightDirection): [x: number, y: number] {
  const { x, y } = lightPosition(light, new Vector3())
  return [x, y]
}

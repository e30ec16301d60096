import { Vector3 } from 'three'

/** Where light comes from, in degrees, as seen by someone who looks at the face: to the right, and up. */
export interface LightDirection {
  readonly yaw: number
  readonly pitch: number
}

/** Largest yaw and pitch: beyond them the face is lit from behind. */
export const MOST_LIGHT = [90, 85] as const

const RADIANS = Math.PI / 180

export function clampedLight({ yaw, pitch }: LightDirection): LightDirection {
  const clamp = (value: number, most: number) => Math.round(Math.min(most, Math.max(-most, value)))
  return { yaw: clamp(yaw, MOST_LIGHT[0]), pitch: clamp(pitch, MOST_LIGHT[1]) }
}

/** A position that a light comes from, for a face that looks along +Z. */
export function lightPosition({ yaw, pitch }: LightDirection, out: Vector3): Vector3 {
  return out.setFromSphericalCoords(1, (90 - pitch) * RADIANS, yaw * RADIANS)
}

export function lightFrom({ x, y, z }: Vector3): LightDirection {
  return clampedLight({ yaw: Math.atan2(x, z) / RADIANS, pitch: Math.atan2(y, Math.hypot(x, z)) / RADIANS })
}

/**
 * The light that a ball shows brightest where it is touched.
 *
 * @param x, y from its centre, 1 at its border, to the right and up; beyond the border it is that of the border.
 */
export function lightOnBall(x: number, y: number): LightDirection {
  const length = Math.max(1, Math.hypot(x, y))
  const [u, v] = [x / length, y / length]
  return lightFrom(new Vector3(u, v, Math.sqrt(Math.max(0, 1 - u * u - v * v))))
}

/** Where on the ball a light is: from its centre, 1 at its border, to the right and up. */
export function ballPoint(light: LightDirection): [x: number, y: number] {
  const { x, y } = lightPosition(light, new Vector3())
  return [x, y]
}

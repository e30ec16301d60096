/** Directions from the face to the directional lights, not normalised. */
export const LIGHTS: readonly (readonly [x: number, y: number, z: number])[] = [
  [-1, 1.35, 0.95],
  [1.3, 0.1, 0.8],
  [1.2, 1, -1.6],
]

export const LIGHT_INTENSITY = 1.2

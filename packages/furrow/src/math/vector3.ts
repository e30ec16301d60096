import { cross, dot, normalize } from './vector.ts'

/** Vector as a tuple, for code in which clarity matters more than speed. `vector.ts` has functions for packed arrays. */
export type Vector = readonly [x: number, y: number, z: number]

/** Returns a vector of a packed array. */
export function vectorAt(vectors: ArrayLike<number>, index: number): Vector {
  return [vectors[3 * index], vectors[3 * index + 1], vectors[3 * index + 2]]
}

export function add([a, b, c]: Vector, [x, y, z]: Vector): Vector {
  return [a + x, b + y, c + z]
}

export function subtract([a, b, c]: Vector, [x, y, z]: Vector): Vector {
  return [a - x, b - y, c - z]
}

export function scale([x, y, z]: Vector, factor: number): Vector {
  return [factor * x, factor * y, factor * z]
}

/** Returns a vector of length 1; the zero vector stays. */
export function unit(v: ArrayLike<number>): Vector {
  const out = Float64Array.from(v)
  normalize(out)
  return vectorAt(out, 0)
}

/** Returns the cross product. */
export function crossed(a: Vector, b: Vector): Vector {
  const out = new Float64Array(3)
  cross(out, a, b)
  return vectorAt(out, 0)
}

/** Returns the unit vector of the part of `v` that is perpendicular to the unit vector `axis`. */
export function across(v: Vector, axis: Vector): Vector {
  return unit(subtract(v, scale(axis, dot(v, axis))))
}

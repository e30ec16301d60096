import { hash32 } from './hash.ts'
import { lerp, smoothstep } from './scalar.ts'

/** Computes one-dimensional value noise, -1..1. The noise has random values at integers, interpolated by `smoothstep`. */
export function noise(x: number, seed: number): number {
  const cell = Math.floor(x)
  return lerp(randomAt(cell, seed), randomAt(cell + 1, seed), smoothstep(x - cell))
}

/** Hashes two integers to a number in -1..1. */
function randomAt(cell: number, seed: number): number {
  return hash32(Math.imul(cell, 0x9e3779b1) ^ Math.imul(seed, 0x85ebca6b)) / 0x7fffffff - 1
}

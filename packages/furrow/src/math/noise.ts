import { hash32 } from './hash.ts'
import { lerp, smoothstep } from './scalar.ts'

/** Value noise in one dimension, -1..1: random values at whole numbers, joined by smoothstep. */
export function noise(x: number, seed: number): number {
  const cell = Math.floor(x)
  return lerp(randomAt(cell, seed), randomAt(cell + 1, seed), smoothstep(x - cell))
}

/** -1..1 from two whole numbers. */
function randomAt(cell: number, seed: number): number {
  return hash32(Math.imul(cell, 0x9e3779b1) ^ Math.imul(seed, 0x85ebca6b)) / 0x7fffffff - 1
}

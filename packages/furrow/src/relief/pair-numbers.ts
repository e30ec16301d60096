import { powerOfTwoFrom } from '../math/scalar.ts'

/**
 * Assigns consecutive numbers, starting at 0, to pairs of vertices such as edges. Uses a hash table with open addressing, which is several
 * times faster than a `Map`.
 */
export class PairNumbers {
  /** Number of different pairs so far. */
  count = 0
  readonly #firsts: Uint32Array
  readonly #seconds: Uint32Array
  /** Hash table with linear probing. A slot stores 1 plus the number of a pair, or 0 if it is free. */
  readonly #slots: Uint32Array

  /** @param most maximum number of different pairs. */
  constructor(most: number) {
    this.#firsts = new Uint32Array(most)
    this.#seconds = new Uint32Array(most)
    this.#slots = new Uint32Array(powerOfTwoFrom(2 * most + 2))
  }

  /** Returns the number of an ordered pair. A new pair gets the next number. */
  numberOf(first: number, second: number): number {
    const slots = this.#slots
    const mask = slots.length - 1
    let slot = hash(first, second) & mask
    for (; slots[slot] > 0; slot = (slot + 1) & mask) {
      const pair = slots[slot] - 1
      if (this.#firsts[pair] === first && this.#seconds[pair] === second) return pair
    }
    this.#firsts[this.count] = first
    this.#seconds[this.count] = second
    slots[slot] = ++this.count
    return this.count - 1
  }
}

/** Hashes a pair with the finaliser of MurmurHash3. */
function hash(first: number, second: number): number {
  let h = Math.imul(first, 0x9e3779b1) ^ second
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return h ^ (h >>> 16)
}

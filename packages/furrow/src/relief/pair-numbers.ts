/**
 * Assigns consecutive numbers to ordered pairs of vertices, such as edges. A hash table with linear probing: a `Map` takes several times as
 * long.
 */
export class PairNumbers {
  /** Number of pairs so far. */
  count = 0
  readonly #firsts: Uint32Array
  readonly #seconds: Uint32Array
  /** Pair number + 1, 0 = free. */
  readonly #slots: Uint32Array

  /** @param most maximum number of pairs. */
  constructor(most: number) {
    this.#firsts = new Uint32Array(most)
    this.#seconds = new Uint32Array(most)
    this.#slots = new Uint32Array(2 ** Math.ceil(Math.log2(2 * most + 2)))
  }

  /** Returns the number of an ordered pair; a new pair gets the next number. */
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

/** Combines both numbers, then applies the finaliser of MurmurHash3. */
function hash(first: number, second: number): number {
  let h = Math.imul(first, 0x9e3779b1) ^ second
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return h ^ (h >>> 16)
}

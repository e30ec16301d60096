/**
 * Numbers pairs of vertices, as edges are, from 0 in the order in which they are first asked for. A table with open addressing: a `Map`
 * of as many pairs takes several times as long.
 */
export class PairNumbers {
  /** How many pairs there are. */
  count = 0
  readonly #firsts: Uint32Array
  readonly #seconds: Uint32Array
  /** Pairs by their hash, from 1; where it is taken, by the next one that is free. */
  readonly #slots: Uint32Array

  /** @param most pairs that may be asked for. */
  constructor(most: number) {
    this.#firsts = new Uint32Array(most)
    this.#seconds = new Uint32Array(most)
    this.#slots = new Uint32Array(2 ** Math.ceil(Math.log2(2 * most + 2)))
  }

  /** The number of a pair, whose order matters; the next one where it is new. */
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

/** The last step of MurmurHash 3. */
function hash(first: number, second: number): number {
  let h = Math.imul(first, 0x9e3779b1) ^ second
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35)
  return h ^ (h >>> 16)
}

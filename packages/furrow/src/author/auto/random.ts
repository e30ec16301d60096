/** Numbers that look random and follow from a seed alone. */
export class Random {
  #state: number

  /** @param name parts of a face draw from numbers of their own, so that one does not change the others. */
  constructor(seed: number, name = '') {
    this.#state = seed | 0
    for (const letter of name) this.#state = Math.imul(this.#state ^ letter.codePointAt(0)!, 0x01000193)
  }

  /** 0 to 1 (mulberry32: T. Ettinger 2017, public domain). */
  next(): number {
    this.#state = (this.#state + 0x6d2b79f5) | 0
    let h = Math.imul(this.#state ^ (this.#state >>> 15), 1 | this.#state)
    h = (h + Math.imul(h ^ (h >>> 7), 61 | h)) ^ h
    return ((h ^ (h >>> 14)) >>> 0) / 4294967296
  }

  between(low: number, high: number): number {
    return low + (high - low) * this.next()
  }

  /** As far to either side as told. */
  sway(most: number): number {
    return this.between(-most, most)
  }
}

/** Pseudo-random number generator. The same seed and stream give the same numbers on every machine. */
export class Rng {
  #state: number

  /** @param stream name of an independent sequence. Drawing from one stream does not change the numbers of another. */
  constructor(seed: number, stream = '') {
    this.#state = seed | 0
    for (const character of stream)
      this.#state = Math.imul(this.#state ^ (character.codePointAt(0) ?? 0), 0x01000193)
  }

  /** Returns a number from 0 to 1, excluding 1 (mulberry32, T. Ettinger 2017, public domain). */
  next(): number {
    this.#state = (this.#state + 0x6d2b79f5) | 0
    let h = Math.imul(this.#state ^ (this.#state >>> 15), 1 | this.#state)
    h = (h + Math.imul(h ^ (h >>> 7), 61 | h)) ^ h
    return ((h ^ (h >>> 14)) >>> 0) / 4294967296
  }

  /** Returns a uniformly distributed number between two bounds. */
  uniform(low: number, high: number): number {
    return low + (high - low) * this.next()
  }

  /** Returns a uniformly distributed number between `-amplitude` and `amplitude`. */
  jitter(amplitude: number): number {
    return this.uniform(-amplitude, amplitude)
  }
}

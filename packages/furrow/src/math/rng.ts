/** Pseudo-random number generator. For the same seed and stream, it returns the same numbers on every machine. */
export class Rng {
  #state: number

  /** @param stream name of a sequence. Each stream has a different sequence of numbers for the same seed. */
  constructor(seed: number, stream = '') {
    this.#state = seed | 0
    for (const character of stream)
      this.#state = Math.imul(this.#state ^ (character.codePointAt(0) ?? 0), 0x01000193)
  }

  /** Returns a generator that continues with the same numbers. */
  copy(): Rng {
    return new Rng(this.#state)
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

  /** Returns an integer, 0..2^31 - 1, for example a seed. */
  integer(): number {
    return Math.floor(2 ** 31 * this.next())
  }
}

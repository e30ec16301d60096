import type { Clock } from '../runtime/face-group.ts'

/** What a frame adds at most, in milliseconds: the first one waits for the shader. */
const LONGEST_STEP = 50

/** How far wrinkles have appeared that came after their face. */
export class Appearance {
  readonly #duration: number
  #elapsed = 0
  /** The time of the last frame. */
  #last: number

  /** @param duration in milliseconds. */
  constructor(duration: number, clock: Clock) {
    this.#duration = duration
    this.#last = clock.now()
  }

  /** Called in every frame. 0 = not yet, 1 = wholly. */
  advance(clock: Clock): number {
    const now = clock.now()
    this.#elapsed += Math.min(Math.max(0, now - this.#last), LONGEST_STEP)
    this.#last = now
    return this.#elapsed < this.#duration ? this.#elapsed / this.#duration : 1
  }
}

import type { Clock } from '../runtime/face-group.ts'

/** Maximum time step per frame, milliseconds. Without a limit, the long first frame, which compiles shaders, would skip the fade-in. */
const MAX_STEP = 50

/** Fade-in of wrinkles added to a face that is already on screen. */
export class Appearance {
  readonly #duration: number
  #elapsed = 0
  /** Time of the last frame, milliseconds. */
  #last: number

  /** @param duration milliseconds. */
  constructor(duration: number, clock: Clock) {
    this.#duration = duration
    this.#last = clock.now()
  }

  /** Advances to the current frame. Returns the opacity, 0..1. */
  advance(clock: Clock): number {
    const now = clock.now()
    this.#elapsed += Math.min(Math.max(0, now - this.#last), MAX_STEP)
    this.#last = now
    return this.#elapsed < this.#duration ? this.#elapsed / this.#duration : 1
  }
}

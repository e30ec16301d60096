/** What a loop drives. */
export interface Animated {
  /** @param delta seconds since the last frame, 0 after a rest. */
  advance(delta: number): void
  draw(): void
  /** Whether there will be something new to draw in the next frame by itself. */
  moving(): boolean
}

/** Longest step in seconds: after a stall things move on, they do not jump. */
const LONGEST_STEP = 0.1

/** Draws when something changed or moves, and not at all otherwise: a page at rest costs nothing. */
export class Loop {
  readonly #animated: Animated
  readonly #onFrame: (cpu: number, interval: number | null) => void
  #request = 0
  #last: number | null = null
  #running = false

  /** @param onFrame told the milliseconds of each frame on the CPU, and those since the last one while moving. */
  constructor(animated: Animated, onFrame: (cpu: number, interval: number | null) => void) {
    this.#animated = animated
    this.#onFrame = onFrame
  }

  start(): void {
    this.#running = true
    this.wake()
  }

  stop(): void {
    this.#running = false
    cancelAnimationFrame(this.#request)
    this.#request = 0
    this.#last = null
  }

  /** Something changed: draw the next frame. */
  wake(): void {
    if (this.#running && this.#request === 0) this.#request = requestAnimationFrame(this.#frame)
  }

  readonly #frame = (now: number): void => {
    this.#request = 0
    const interval = this.#last === null ? null : now - this.#last
    const before = performance.now()
    this.#animated.advance(Math.min((interval ?? 0) / 1000, LONGEST_STEP))
    this.#animated.draw()
    this.#onFrame(performance.now() - before, interval)
    const moving = this.#animated.moving()
    this.#last = moving || this.#request !== 0 ? now : null
    if (moving) this.wake()
  }
}

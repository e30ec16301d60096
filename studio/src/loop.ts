export interface Animated {
  /** @param delta seconds since the last frame, 0 after a pause. */
  advance(delta: number): void
  draw(): void
  /** Whether the next frame will differ from the last one without user input. */
  isMoving(): boolean
}

/** Maximum time step in seconds, to avoid jumps after a slow frame. */
const MAX_STEP = 0.1

/** Render loop. Draws after each change, and continuously while the animation moves. */
export class Loop {
  readonly #animated: Animated
  readonly #onFrame: (cpu: number, interval: number | null) => void
  #request = 0
  #last: number | null = null
  #running = false

  /** @param onFrame receives the CPU time of each frame and, while moving, the time since the last frame, in milliseconds. */
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

  /** Requests the next frame after a change. */
  wake(): void {
    if (this.#running && this.#request === 0) this.#request = requestAnimationFrame(this.#frame)
  }

  readonly #frame = (now: number): void => {
    this.#request = 0
    const interval = this.#last === null ? null : now - this.#last
    const before = performance.now()
    this.#animated.advance(Math.min((interval ?? 0) / 1000, MAX_STEP))
    this.#animated.draw()
    this.#onFrame(performance.now() - before, interval)
    const isMoving = this.#animated.isMoving()
    this.#last = isMoving || this.#request !== 0 ? now : null
    if (isMoving) this.wake()
  }
}

/** Frames in a row in which nothing has moved before a face is composed: half a second at 60 Hz, so that a pause in speech does not. */
const PATIENCE = 30

/** Pixels that a face must cover: below, the shader saves less than another texture and what draws it are worth. */
const LEAST_PIXELS = 64 * 64

/**
 * Whether a face is drawn with a composed map. While it moves it is not: by processor time on a software rasteriser the map's redraw costs
 * what the shader saves, and on the processor a dozen passes.
 */
export class ComposePolicy {
  #still = 0

  /**
   * Called once in a frame.
   *
   * @param hasMoved whether the picture of the wrinkles has changed since the last call.
   * @param pixels that the face covers, at most.
   */
  step(hasMoved: boolean, pixels: number): boolean {
    this.#still = hasMoved || pixels < LEAST_PIXELS ? 0 : this.#still + 1
    return this.#still > PATIENCE
  }

  /** Counts from the beginning. */
  reset(): void {
    this.#still = 0
  }
}

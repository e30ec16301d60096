/** Frames in a row that a face must be fit for another map before it has one: half a second at 60 Hz, so that a pause in speech does not. */
const PATIENCE = 30

/** Pixels that a face must cover: below, the shader saves less than another texture and what draws it are worth. */
const LEAST_PIXELS = 64 * 64

/** Pixels that a face must cover for each texel that is redrawn as it moves: below, a redraw takes longer than the shader saves. */
const PIXELS_PER_TEXEL = 8

/** How many of them are enough for a face that is composed already, so that a camera that moves to and fro does not change it each time. */
const ENOUGH = 0.7

/** Whether a face is drawn with a composed map: while it holds still, and while it moves where a redraw is worth it. */
export class ComposePolicy {
  #fit = 0

  /**
   * Called once in a frame.
   *
   * @param hasMoved whether the picture of the wrinkles has changed since the last call.
   * @param pixels that the face covers, at most.
   * @param texels that are redrawn as it moves, at most, of all maps together.
   */
  step(hasMoved: boolean, pixels: number, texels: number): boolean {
    const isFit = pixels >= LEAST_PIXELS && (!hasMoved || this.isRedrawn(pixels, texels))
    this.#fit = isFit ? this.#fit + 1 : 0
    return this.#fit > PATIENCE
  }

  /** Whether a face that moves is drawn with a composed map, once there is one. */
  isRedrawn(pixels: number, texels: number): boolean {
    const needed = PIXELS_PER_TEXEL * texels
    return pixels >= (this.#fit > PATIENCE ? ENOUGH * needed : needed)
  }

  /** Counts from the beginning. */
  reset(): void {
    this.#fit = 0
  }
}

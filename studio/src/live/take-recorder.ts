import { FurrowError } from 'furrow'
import { motionOf, TAKE_RATE, type TakeMotion } from '../document/take.ts'

/** Maximum duration of a recorded take, seconds. */
export const MAX_SECONDS = 600

/** Collects the weights of a face over time. */
export class TakeRecorder {
  readonly #times: number[] = []
  readonly #columns = new Map<string, number[]>()

  /** Time since the first frame, seconds. */
  get seconds(): number {
    return this.#times.length > 0 ? this.#times.at(-1)! - this.#times[0] : 0
  }

  /**
   * Adds a frame. Skips frames that arrive faster than key frames are kept.
   *
   * @param seconds time of the frame.
   * @param weights weights of blendshapes, by name.
   */
  add(seconds: number, weights: ReadonlyMap<string, number>): void {
    const last = this.#times.at(-1)
    if (last !== undefined && seconds - last < 0.5 / TAKE_RATE) return
    const before = this.#times.length
    this.#times.push(seconds)
    for (const [name, weight] of weights) {
      // A blendshape that a muscle adds during the recording was 0 before.
      if (!this.#columns.has(name)) this.#columns.set(name, new Array<number>(before).fill(0))
      this.#columns.get(name)!.push(weight)
    }
    for (const column of this.#columns.values()) if (column.length === before) column.push(0)
  }

  /** @throws FurrowError if fewer than two frames arrived. */
  finish(): TakeMotion {
    if (this.#times.length < 2) throw emptyError()
    return motionOf(this.#times, this.#columns)
  }
}

function emptyError(): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'nothing was recorded, because no scores arrived',
    remedy: 'wait until the source shows a face, then record again',
  })
}

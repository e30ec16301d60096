import { FurrowError } from '../error.ts'
import { MAX_WRINKLE_BYTES } from '../limits.ts'
import type { TextureShape } from './rules.ts'

const MIB = 2 ** 20

/** Counts what the images of a file's wrinkles take once they are decoded. Loaders and `furrow validate` count alike. */
export class DecodedBytes {
  readonly #counted = new Set<number>()
  #sum = 0

  /**
   * Counts the image of a texture once, in RGBA and all of its slices.
   *
   * @throws FurrowError where all that were counted are too large together.
   */
  add(texture: number, { width, height, slices }: Omit<TextureShape, 'layout'>, who: string): void {
    if (!this.#counted.has(texture)) this.#sum += 4 * width * height * Math.max(slices ?? 1, 1)
    this.#counted.add(texture)
    this.check(who)
  }

  /** Throws FurrowError where those that were counted are too large together. */
  check(who: string): void {
    if (this.#sum <= MAX_WRINKLE_BYTES) return
    throw new FurrowError({
      code: 'out-of-range',
      who,
      problem: 'the images of the wrinkles are too large together',
      value: `${Math.ceil(this.#sum / MIB)} MiB decoded`,
      limit: `${MAX_WRINKLE_BYTES / MIB} MiB for all of a file`,
      remedy: 'scale them down',
    })
  }
}

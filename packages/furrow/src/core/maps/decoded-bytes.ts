import { FurrowError } from '../error.ts'
import { MAX_WRINKLE_BYTES } from '../limits.ts'
import type { TextureShape } from './rules.ts'

const MIB = 2 ** 20

/** Sums the decoded sizes of a file's wrinkle images, and throws if the sum exceeds `MAX_WRINKLE_BYTES`. */
export class DecodedBytes {
  readonly #counted = new Set<number>()
  #sum = 0

  /**
   * Adds the decoded size of all slices of a texture, in RGBA. A texture that is added again does not count again.
   *
   * @param texture index of the texture in the file.
   * @param who name of the file or material in errors.
   * @throws FurrowError if the sum exceeds `MAX_WRINKLE_BYTES`.
   */
  add(texture: number, { width, height, slices }: Omit<TextureShape, 'layout'>, who: string): void {
    if (!this.#counted.has(texture)) this.#sum += 4 * width * height * Math.max(slices ?? 1, 1)
    this.#counted.add(texture)
    this.check(who)
  }

  /** @throws FurrowError if the sum exceeds `MAX_WRINKLE_BYTES`. */
  check(who: string): void {
    if (this.#sum <= MAX_WRINKLE_BYTES) return
    throw new FurrowError({
      code: 'out-of-range',
      who,
      problem: 'total size of the wrinkle images too large',
      value: `${Math.ceil(this.#sum / MIB)} MiB decoded`,
      limit: `${MAX_WRINKLE_BYTES / MIB} MiB per file`,
      remedy: 'scale the images down',
    })
  }
}

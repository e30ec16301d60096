import type { Face } from './face.ts'

/**
 * What the activations of faces were computed from. While none of it changes, a face stands: its activations need not be computed
 * again. In a few long arrays, since those of thousands of faces are not in the processor's cache, and these it reads ahead.
 */
export class LastInputs {
  /** Those of a face after those of the one before. */
  readonly #values: Float64Array
  readonly #count: number
  /** By face: whether its activations are to be computed. */
  readonly isDue: Uint8Array
  readonly #resting: Float64Array
  readonly #activations: Float64Array

  /**
   * @param faces number of faces.
   * @param count inputs of each.
   */
  constructor(faces: number, count: number) {
    this.#values = new Float64Array(faces * count)
    this.#count = count
    this.isDue = new Uint8Array(faces).fill(1)
    this.#resting = new Float64Array(faces)
    this.#activations = new Float64Array(faces)
  }

  /** Compares a face's inputs with its last ones, and keeps them. NaN is always a change. */
  take(face: number, values: Float64Array): void {
    const start = face * this.#count
    for (let i = 0; i < values.length; i++) {
      if (values[i] === this.#values[start + i]) continue
      for (; i < values.length; i++) this.#values[start + i] = values[i]
      this.isDue[face] = 1
      return
    }
  }

  /** Writes the inputs of a face. */
  get(face: number, values: Float64Array): void {
    const start = face * this.#count
    for (let i = 0; i < values.length; i++) values[i] = this.#values[start + i]
  }

  /** Whether a face is to be computed; also where the application has changed its activations, at rest or not, or its areas. */
  check(face: number, { resting, activations }: Face): boolean {
    if (resting.version !== this.#resting[face] || activations.version !== this.#activations[face])
      this.isDue[face] = 1
    return this.isDue[face] === 1
  }

  /** A face has been computed, and has its activations. */
  settle(face: number, { resting, activations }: Face): void {
    this.#resting[face] = resting.version
    this.#activations[face] = activations.version
    this.isDue[face] = 0
  }
}

import type { Face } from './face.ts'

/**
 * Inputs from which the activations of faces were last computed; a face with unchanged inputs is skipped. Stored in a few long arrays,
 * because the CPU prefetches sequential reads of thousands of faces.
 */
export class LastInputs {
  /** Inputs of all faces, `#count` per face. */
  readonly #values: Float64Array
  readonly #count: number
  /** By face: whether activations must be computed. */
  readonly isDue: Uint8Array
  readonly #resting: Float64Array
  readonly #activations: Float64Array

  /**
   * @param faces number of faces.
   * @param count number of inputs per face.
   */
  constructor(faces: number, count: number) {
    this.#values = new Float64Array(faces * count)
    this.#count = count
    this.isDue = new Uint8Array(faces).fill(1)
    this.#resting = new Float64Array(faces)
    this.#activations = new Float64Array(faces)
  }

  /** Stores a face's inputs and detects changes. NaN always counts as a change. */
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

  /** Whether a face must be computed. Detects changes of areas and activations by the application. */
  check(face: number, { resting, activations }: Face): boolean {
    if (resting.version !== this.#resting[face] || activations.version !== this.#activations[face])
      this.isDue[face] = 1
    return this.isDue[face] === 1
  }

  /** Marks a face as computed. */
  settle(face: number, { resting, activations }: Face): void {
    this.#resting[face] = resting.version
    this.#activations[face] = activations.version
    this.isDue[face] = 0
  }
}

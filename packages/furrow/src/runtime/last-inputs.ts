import type { Face } from './face.ts'

/**
 * Stores the inputs from which the activations of each face were last computed. Faces with unchanged inputs can then be skipped. The values
 * of all faces are in a few long arrays, because CPUs prefetch sequential reads.
 */
export class LastInputs {
  /** Inputs of all faces, `#count` per face. */
  readonly #values: Float64Array
  readonly #count: number
  /** For each face, 1 if activations must be computed, otherwise 0. */
  readonly isDue: Uint8Array
  readonly #resting: Float64Array
  readonly #activations: Float64Array

  /** @param count number of inputs per face. */
  constructor(faces: number, count: number) {
    this.#values = new Float64Array(faces * count)
    this.#count = count
    this.isDue = new Uint8Array(faces).fill(1)
    this.#resting = new Float64Array(faces)
    this.#activations = new Float64Array(faces)
  }

  /** Stores the inputs of a face, and sets `isDue` if they have changed. NaN always counts as a change. */
  take(face: number, values: Float64Array): void {
    const start = face * this.#count
    for (let i = 0; i < values.length; i++) {
      if (values[i] === this.#values[start + i]) continue
      for (; i < values.length; i++) this.#values[start + i] = values[i]
      this.isDue[face] = 1
      return
    }
  }

  /** Copies the stored inputs of a face to `values`. */
  get(face: number, values: Float64Array): void {
    const start = face * this.#count
    for (let i = 0; i < values.length; i++) values[i] = this.#values[start + i]
  }

  /**
   * Returns whether the activations of a face must be computed. They must be if its inputs, its resting activations, its activations or its list of
   * areas have changed since the last `settle`.
   */
  check(face: number, { resting, activations }: Face): boolean {
    if (resting.version !== this.#resting[face] || activations.version !== this.#activations[face])
      this.isDue[face] = 1
    return this.isDue[face] === 1
  }

  /** Marks the activations of a face as computed. */
  settle(face: number, { resting, activations }: Face): void {
    this.#resting[face] = resting.version
    this.#activations[face] = activations.version
    this.isDue[face] = 0
  }
}

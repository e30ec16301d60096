import type { ConflictDriver } from './types.ts'

interface Pair {
  a: Uint16Array
  b: Uint16Array
}

/** Takes from opposite blendshapes what both have. Nothing is allocated by `resolve`. */
export class Conflicts {
  /** Names that no input has. */
  readonly unknown: readonly string[]
  readonly #pairs: readonly Pair[]
  readonly #weights: Float32Array

  /**
   * @param find places of a weight by name, those of its parts where it is split.
   * @param count of the weights.
   */
  constructor(drivers: readonly ConflictDriver[], find: (name: string) => readonly number[], count: number) {
    this.unknown = drivers.flatMap(({ targets }) => targets).filter((name) => find(name).length === 0)
    this.#pairs = drivers
      .map(({ targets: [a, b] }) => ({ a: Uint16Array.from(find(a)), b: Uint16Array.from(find(b)) }))
      .filter(({ a, b }) => a.length > 0 && b.length > 0)
    this.#weights = new Float32Array(this.#pairs.length > 0 ? count : 0)
  }

  /** Whether there is anything to resolve. */
  get any(): boolean {
    return this.#pairs.length > 0
  }

  /** The weights with what opposes taken away; valid until the next call. */
  resolve(weights: ArrayLike<number>, offset: number): Float32Array {
    const out = this.#weights
    for (let i = 0; i < out.length; i++) out[i] = weights[offset + i]
    for (let i = 0; i < this.#pairs.length; i++) {
      const { a, b } = this.#pairs[i]
      let ofA = 0
      let ofB = 0
      for (let k = 0; k < a.length; k++) ofA += out[a[k]] / a.length
      for (let k = 0; k < b.length; k++) ofB += out[b[k]] / b.length
      const shared = Math.min(ofA, ofB)
      if (!(shared > 0)) continue
      for (let k = 0; k < a.length; k++) out[a[k]] -= shared
      for (let k = 0; k < b.length; k++) out[b[k]] -= shared
    }
    return out
  }
}

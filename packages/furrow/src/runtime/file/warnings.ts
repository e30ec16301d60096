import { fileError } from './file-error.ts'

/** Warns of the faults of a file, of each once. */
export class Warnings {
  readonly #texts = new Set<string>()
  readonly #who: string

  /** @param who names the loader in faults that name nothing themselves. */
  constructor(who: string) {
    this.#who = who
  }

  /**
   * @param fault what was thrown.
   * @param consequence what the page shows instead.
   */
  add(fault: unknown, consequence: string): void {
    const { message } = fileError(fault, this.#who, 'the wrinkles cannot be added')
    const text = `${message} (${consequence})`
    if (this.#texts.has(text)) return
    this.#texts.add(text)
    console.warn(text)
  }
}

import { fileError } from './file-error.ts'

/** Warns of the faults of a file, of each once. */
export class Warnings {
  readonly #texts = new Set<string>()

  /**
   * @param fault what was thrown.
   * @param consequence what the page shows instead.
   */
  add(fault: unknown, consequence: string): void {
    const { message } = fileError(fault, 'WrinkleLoaderPlugin', 'the wrinkles cannot be added')
    const text = `${message} (${consequence})`
    if (this.#texts.has(text)) return
    this.#texts.add(text)
    console.warn(text)
  }
}

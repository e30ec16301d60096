import { FurrowError } from '../../core/error.ts'

/** Warns of the faults of a file, of each once. */
export class Warnings {
  readonly #texts = new Set<string>()

  /**
   * @param fault what was thrown.
   * @param consequence what the page shows instead.
   */
  add(fault: unknown, consequence: string): void {
    const { message } = fault instanceof FurrowError ? fault : unexpected(fault)
    const text = `${message} (${consequence})`
    if (this.#texts.has(text)) return
    this.#texts.add(text)
    console.warn(text)
  }
}

function unexpected(fault: unknown): FurrowError {
  return new FurrowError({
    who: 'WrinkleLoaderPlugin',
    what: 'the wrinkles cannot be added',
    value: fault instanceof Error ? fault.message : fault,
    remedy: 'check the file with `npx furrow validate`',
  })
}

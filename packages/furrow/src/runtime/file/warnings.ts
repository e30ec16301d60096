import type { FurrowError } from '../../core/error.ts'
import { fileError } from './file-error.ts'

/** Logs warnings about a file. Equal warnings are logged once. */
export class Warnings {
  readonly #texts = new Set<string>()
  readonly #who: string

  /** @param who name of the loader, for errors that are not a FurrowError. */
  constructor(who: string) {
    this.#who = who
  }

  /** @param consequence result that the user sees, such as "the face has no wrinkles". */
  add(thrown: unknown, consequence: string): void {
    const { message } = fileError(thrown, this.#who, 'the wrinkles cannot be added')
    this.addText(`${message} (${consequence})`)
  }

  /** Logs one warning for all malformed drivers of a material. */
  addDrivers(errors: readonly FurrowError[]): void {
    this.addText(describeDriverErrors(errors))
  }

  addText(text: string): void {
    if (this.#texts.has(text)) return
    this.#texts.add(text)
    console.warn(text)
  }
}

/** Describes the malformed drivers of a material: the first error and the number of others. */
export function describeDriverErrors([first, ...others]: readonly FurrowError[]): string {
  const count = others.length === 1 ? '1 more is' : `${others.length} more are`
  const rest = others.length > 0 ? `${count} malformed; ` : ''
  return `${first.message} (${rest}the other drivers work)`
}

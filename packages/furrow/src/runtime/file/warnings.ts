import type { FurrowError } from '../../core/error.ts'
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
    this.#warn(`${message} (${consequence})`)
  }

  /** Warns of the malformed drivers of a material, all at once. */
  addDrivers(faults: readonly FurrowError[]): void {
    this.#warn(describeDriverFaults(faults))
  }

  #warn(text: string): void {
    if (this.#texts.has(text)) return
    this.#texts.add(text)
    console.warn(text)
  }
}

/** One sentence for the malformed drivers of a material: the first fault, and the number of the others. */
export function describeDriverFaults([first, ...others]: readonly FurrowError[]): string {
  const count = others.length === 1 ? '1 more is' : `${others.length} more are`
  const rest = others.length > 0 ? `${count} malformed; ` : ''
  return `${first.message} (${rest}the other drivers work)`
}

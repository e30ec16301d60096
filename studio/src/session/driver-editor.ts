import type { WrinkleDriver } from 'furrow'
import type { StudioDocument } from '../document/document.ts'
import { addDriver, removeDriver, setDriver } from '../document/drivers.ts'
import { STEP } from '../labels/steps.ts'
import type { Session } from './session.ts'

/** Edits the document's drivers by index. Each change is one undo step. */
export class DriverEditor {
  readonly #session: Session
  readonly #attempt: (task: () => void) => unknown

  /** @param attempt runs a task and shows its error. */
  constructor(session: Session, attempt: (task: () => void) => unknown) {
    this.#session = session
    this.#attempt = attempt
  }

  add(driver: WrinkleDriver): void {
    this.#edit(STEP.addDriver, (document) => addDriver(document, driver))
  }

  /**
   * Changes fields of a driver.
   *
   * @param field name of the changed field. Changes of the same field until `settle` are one undo step.
   */
  set(index: number, field: string, fields: Readonly<Record<string, unknown>>): void {
    const change = (document: StudioDocument) => {
      const next: Record<string, unknown> = { ...document.drivers[index], ...fields }
      return setDriver(document, index, next as WrinkleDriver)
    }
    this.#edit(STEP.changeDriver, change, `${field} of driver ${index}`)
  }

  /** Ends the undo step of consecutive calls of `set`. */
  settle(): void {
    this.#session.settle()
  }

  remove(index: number): void {
    this.#edit(STEP.removeDriver, (document) => removeDriver(document, index))
  }

  #edit(label: string, operation: (document: StudioDocument) => StudioDocument, key?: string): void {
    this.#attempt(() => this.#session.edit(label, operation, key))
  }
}

/** Maximum number of errors that are shown at once. */
const SHOWN = 2

export interface Message {
  readonly text: string
}

/** Errors of the page, the newest last. Each text occurs once. */
export class MessageList {
  #messages: readonly Message[] = []
  #isUnfolded = false

  get messages(): readonly Message[] {
    return this.#messages
  }

  /** Messages to show: the newest ones, or all if the list is unfolded. */
  get shown(): readonly Message[] {
    return this.#isUnfolded ? this.#messages : this.#messages.slice(-SHOWN)
  }

  /** Number of older messages that are not shown. */
  get folded(): number {
    return this.#messages.length - this.shown.length
  }

  add(text: string): void {
    this.#messages = [...this.#messages.filter((each) => each.text !== text), { text }]
  }

  /** Removes messages. Folds the list when it is empty. */
  remove(messages: readonly Message[]): void {
    this.#messages = this.#messages.filter((message) => !messages.includes(message))
    if (this.#messages.length === 0) this.#isUnfolded = false
  }

  unfold(): void {
    this.#isUnfolded = true
  }
}

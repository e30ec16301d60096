import { type Message, MessageList } from './message-list.ts'

/** Milliseconds before a note disappears. */
const NOTE_DURATION = 6000

/** Labels of the controls beside messages. */
export interface MessageLabels {
  dismiss: string
  /** Returns the label of older errors that are not shown. */
  more(count: number): string
}

/** Shows notes and errors, and announces them to screen readers. Errors stay until dismissed, or until the next file has opened. */
export class Messages {
  readonly #errors: HTMLElement
  readonly #notes: HTMLElement
  readonly #labels: MessageLabels
  readonly #list = new MessageList()
  /** Elements of the shown errors. They stay while shown, so that screen readers announce only new ones. */
  readonly #items = new Map<Message, HTMLElement>()
  readonly #more = document.createElement('button')
  #noteTimer = 0

  /** @param errors element with the role `alert`. @param notes element with the role `status`. */
  constructor(errors: HTMLElement, notes: HTMLElement, labels: MessageLabels) {
    this.#labels = labels
    this.#errors = errors
    this.#notes = notes
    this.#more.type = 'button'
    this.#more.className = 'more'
    this.#more.onclick = () => {
      this.#list.unfold()
      this.#render()
    }
    addEventListener('unhandledrejection', ({ reason }) => this.error(reason))
    addEventListener('error', ({ error, message }) => this.error(error ?? message))
  }

  error(error: unknown): void {
    const text = error instanceof Error ? error.message : String(error)
    this.#list.add(text)
    this.#render()
  }

  note(text: string): void {
    this.#notes.textContent = text
    clearTimeout(this.#noteTimer)
    this.#noteTimer = window.setTimeout(() => this.#notes.replaceChildren(), NOTE_DURATION)
  }

  /** Runs a task and shows the error if it throws. Returns whether it succeeded. */
  async attempt(task: () => unknown): Promise<boolean> {
    try {
      await task()
      return true
    } catch (error) {
      this.error(error)
      return false
    }
  }

  /** Runs a task that opens a file, as `attempt` does. If it causes no error, removes the errors that were shown before. */
  async attemptOpening(task: () => unknown): Promise<void> {
    const before = this.#list.messages
    await this.attempt(task)
    if (this.#list.messages.every((message) => before.includes(message))) this.#remove(before)
  }

  #remove(messages: readonly Message[]): void {
    this.#list.remove(messages)
    this.#render()
  }

  #render(): void {
    const { shown, folded } = this.#list
    for (const [message, item] of this.#items) {
      if (shown.includes(message)) continue
      item.remove()
      this.#items.delete(message)
    }
    for (const [i, message] of shown.entries()) {
      const item = this.#items.get(message) ?? this.#itemOf(message)
      this.#items.set(message, item)
      if (this.#errors.children[i] !== item) this.#errors.insertBefore(item, this.#errors.children[i] ?? null)
    }
    this.#more.textContent = this.#labels.more(folded)
    if (folded > 0) this.#errors.append(this.#more)
    else this.#more.remove()
  }

  #itemOf(message: Message): HTMLElement {
    const item = document.createElement('p')
    const dismiss = document.createElement('button')
    dismiss.type = 'button'
    dismiss.className = 'dismiss'
    dismiss.ariaLabel = this.#labels.dismiss
    dismiss.textContent = '×'
    dismiss.onclick = () => this.#remove([message])
    item.append(message.text, dismiss)
    return item
  }
}

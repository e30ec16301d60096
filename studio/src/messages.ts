/** Milliseconds before a note disappears. */
const NOTE_DURATION = 6000

/** Shows notes and errors, and announces them to screen readers. Errors stay until dismissed. */
export class Messages {
  readonly #errors: HTMLElement
  readonly #notes: HTMLElement
  #noteTimer = 0

  /** @param errors element with the role `alert`. @param notes element with the role `status`. */
  constructor(errors: HTMLElement, notes: HTMLElement) {
    this.#errors = errors
    this.#notes = notes
    addEventListener('unhandledrejection', ({ reason }) => this.error(reason))
    addEventListener('error', ({ error, message }) => this.error(error ?? message))
  }

  error(error: unknown): void {
    const text = error instanceof Error ? error.message : String(error)
    const item = document.createElement('p')
    const dismiss = document.createElement('button')
    dismiss.type = 'button'
    dismiss.className = 'dismiss'
    dismiss.ariaLabel = 'Dismiss'
    dismiss.textContent = '×'
    dismiss.onclick = () => item.remove()
    item.append(text, dismiss)
    for (const same of this.#errors.children) if (same.firstChild?.textContent === text) same.remove()
    this.#errors.append(item)
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
}

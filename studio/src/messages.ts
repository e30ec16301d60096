/** Milliseconds that a message which is no error stays. */
const STAY = 6000

/** Says what happened, on the screen and to screen readers. Errors stay until they are dismissed. */
export class Messages {
  readonly #errors: HTMLElement
  readonly #notes: HTMLElement
  #fade = 0

  /** @param errors live region of role alert. @param notes live region of role status. */
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
    clearTimeout(this.#fade)
    this.#fade = window.setTimeout(() => this.#notes.replaceChildren(), STAY)
  }

  /** Runs something a user asked for; what it throws is shown. */
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

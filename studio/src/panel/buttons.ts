import { spoken } from '../words.ts'

/** A row of buttons, one of which may be the one in force. */
export class Buttons<T extends string> {
  readonly #buttons: Map<T, HTMLButtonElement>

  /** @param signs short signs for some, where their names are too long. */
  constructor(
    root: HTMLElement,
    names: readonly T[],
    onPress: (name: T) => void,
    signs?: Readonly<Partial<Record<T, string>>>,
  ) {
    this.#buttons = new Map(
      names.map((name) => {
        const button = document.createElement('button')
        button.type = 'button'
        button.textContent = signs?.[name] ?? spoken(name)
        if (signs?.[name]) button.ariaLabel = button.title = spoken(name)
        button.addEventListener('click', () => onPress(name))
        return [name, button]
      }),
    )
    root.replaceChildren(...this.#buttons.values())
    this.show(null)
  }

  show(name: T | null): void {
    for (const [own, button] of this.#buttons) {
      const pressed = String(own === name)
      if (button.ariaPressed !== pressed) button.ariaPressed = pressed
    }
  }
}

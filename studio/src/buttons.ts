import { displayName } from './display-name.ts'

/** Row of buttons with at most one pressed. */
export class Buttons<T extends string> {
  readonly #buttons: Map<T, HTMLButtonElement>

  /** @param shortLabels replacements for long labels. */
  constructor(
    root: HTMLElement,
    names: readonly T[],
    onPress: (name: T) => void,
    shortLabels?: Readonly<Partial<Record<T, string>>>,
  ) {
    this.#buttons = new Map(
      names.map((name) => {
        const button = document.createElement('button')
        button.type = 'button'
        button.textContent = shortLabels?.[name] ?? displayName(name)
        if (shortLabels?.[name]) button.title = displayName(name)
        button.addEventListener('click', () => onPress(name))
        return [name, button]
      }),
    )
    root.replaceChildren(...this.#buttons.values())
    this.show(null)
  }

  show(name: T | null): void {
    for (const [buttonName, button] of this.#buttons) {
      const pressed = String(buttonName === name)
      if (button.ariaPressed !== pressed) button.ariaPressed = pressed
    }
  }
}

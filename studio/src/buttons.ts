/** Row of buttons with at most one pressed. */
export class Buttons<T extends string> {
  readonly #buttons: Map<T, HTMLButtonElement>

  /** @param labels labels of the buttons, and their tooltips. */
  constructor(
    root: HTMLElement,
    names: readonly T[],
    onPress: (name: T) => void,
    labels: Readonly<Record<T, { label: string; title?: string }>>,
  ) {
    this.#buttons = new Map(
      names.map((name) => {
        const button = document.createElement('button')
        button.type = 'button'
        const { label, title } = labels[name]
        button.textContent = label
        if (title) button.title = title
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

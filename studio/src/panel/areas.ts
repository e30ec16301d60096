import type { Dial } from '../dials.ts'
import { Slider } from './slider.ts'

export interface AreasActions {
  input(dial: Dial, value: number): void
  remove(name: string): void
}

/** A slider per area, each with a button that removes it. */
export class AreasPanel {
  readonly #list: HTMLElement
  readonly #actions: AreasActions
  #sliders: Slider[] = []

  constructor(list: HTMLElement, actions: AreasActions) {
    this.#list = list
    this.#actions = actions
  }

  /** Shows another list of areas; focus stays at the place where it was. */
  show(dials: readonly Dial[]): void {
    const buttons = () => [...this.#list.querySelectorAll<HTMLButtonElement>('button')]
    const focused = buttons().indexOf(document.activeElement as HTMLButtonElement)
    this.#sliders = dials.map((dial) => new Slider(dial, this.#actions.input))
    this.#list.replaceChildren(...this.#sliders.map((slider) => this.#withRemove(slider)))
    if (focused >= 0) buttons()[Math.min(focused, dials.length - 1)]?.focus()
  }

  follow(): void {
    for (const slider of this.#sliders) slider.follow()
  }

  #withRemove({ row, dial }: Slider): HTMLElement {
    const remove = document.createElement('button')
    remove.type = 'button'
    remove.className = 'remove'
    remove.ariaLabel = `Remove area ${dial.name}`
    remove.title = 'Remove'
    remove.textContent = '×'
    remove.addEventListener('click', () => this.#actions.remove(dial.name))
    row.classList.add('removable')
    row.append(remove)
    return row
  }
}

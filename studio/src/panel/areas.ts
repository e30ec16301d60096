import type { Dial } from '../dials.ts'
import { Slider } from './slider.ts'

export interface AreasActions {
  input(dial: Dial, value: number): void
  point(dial: Dial | null): void
  remove(name: string): void
}

/** A slider per area, each with a button that removes it. */
export class AreasPanel {
  readonly #list: HTMLElement
  readonly #why = document.createElement('p')
  readonly #actions: AreasActions
  #sliders: Slider[] = []

  constructor(list: HTMLElement, actions: AreasActions) {
    this.#list = list
    this.#actions = actions
    this.#why.className = 'why'
    this.#why.hidden = true
    list.after(this.#why)
  }

  /** Marks the areas that something else moves. */
  mark(names: readonly string[]): void {
    for (const slider of this.#sliders) slider.mark(names.includes(slider.dial.name))
  }

  /** Says below the list what moves an area; nothing where there is nothing to say. */
  explain(lines: readonly string[]): void {
    this.#why.replaceChildren(...lines.flatMap((line) => [line, document.createElement('br')]))
    this.#why.hidden = lines.length === 0
  }

  /** Shows another list of areas; focus stays at the place where it was. */
  show(dials: readonly Dial[]): void {
    const buttons = () => [...this.#list.querySelectorAll<HTMLButtonElement>('button')]
    const focused = buttons().indexOf(document.activeElement as HTMLButtonElement)
    this.#sliders = dials.map((dial) => new Slider(dial, this.#actions.input, this.#actions.point))
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

import type { Dial } from '../viewer/dials.ts'
import { Slider } from './slider.ts'

export interface AreasActions {
  input(dial: Dial, value: number): void
  hover(dial: Dial | null): void
  remove(name: string): void
}

/** A slider per area, each with a button that removes it. */
export class AreasPanel {
  readonly #list: HTMLElement
  readonly #explanation = document.createElement('p')
  readonly #actions: AreasActions
  #sliders: Slider[] = []

  constructor(list: HTMLElement, actions: AreasActions) {
    this.#list = list
    this.#actions = actions
    this.#explanation.className = 'explanation'
    this.#explanation.hidden = true
    list.after(this.#explanation)
  }

  /** Marks the areas that the hovered blendshape drives. */
  mark(names: readonly string[]): void {
    for (const slider of this.#sliders) slider.mark(names.includes(slider.dial.name))
  }

  /** Shows what drives an area, one line each; hides the text if there are none. */
  explain(lines: readonly string[]): void {
    this.#explanation.replaceChildren(...lines.flatMap((line) => [line, document.createElement('br')]))
    this.#explanation.hidden = lines.length === 0
  }

  /** Shows another list of areas; the focus stays at the same index. */
  show(dials: readonly Dial[]): void {
    const buttons = () => [...this.#list.querySelectorAll<HTMLButtonElement>('button')]
    const focused = buttons().indexOf(document.activeElement as HTMLButtonElement)
    this.#sliders = dials.map((dial) => new Slider(dial, this.#actions.input, this.#actions.hover))
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

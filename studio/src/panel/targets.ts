import { type Dial, groupDials } from '../viewer/dials.ts'
import { Slider } from './slider.ts'

interface Group {
  element: HTMLDetailsElement
  count: HTMLElement
  sliders: Slider[]
}

/** A slider per blendshape, in collapsible groups, with a filter by name. */
export class TargetsPanel {
  readonly #list: HTMLElement
  readonly #filter: HTMLInputElement
  readonly #found: HTMLElement
  readonly #onInput: (dial: Dial, value: number) => void
  readonly #onHover: (dial: Dial | null) => void
  #groups: Group[] = []
  #collapsed = new Map<string, boolean>()

  constructor(
    list: HTMLElement,
    filter: HTMLInputElement,
    found: HTMLElement,
    onInput: (dial: Dial, value: number) => void,
    onHover: (dial: Dial | null) => void,
  ) {
    this.#list = list
    this.#filter = filter
    this.#found = found
    this.#onInput = onInput
    this.#onHover = onHover
    filter.addEventListener('input', () => this.#apply())
  }

  show(dials: readonly Dial[]): void {
    if (!this.#list.classList.contains('filtered')) this.#remember()
    this.#groups = groupDials(dials).map((group) => {
      const element = document.createElement('details')
      const summary = document.createElement('summary')
      const count = document.createElement('span')
      summary.append(group.name, count)
      const sliders = group.dials.map((dial) => new Slider(dial, this.#onInput, this.#onHover))
      element.append(summary, ...sliders.map(({ row }) => row))
      element.dataset.name = group.name
      element.open = this.#collapsed.get(group.name) === false
      return { element, count, sliders }
    })
    this.#list.replaceChildren(...this.#groups.map(({ element }) => element))
    this.#apply()
  }

  follow(): void {
    for (const { sliders } of this.#groups) for (const slider of sliders) slider.follow()
  }

  /** Marks the blendshapes that drive the hovered area. */
  mark(names: readonly string[]): void {
    for (const { element, sliders } of this.#groups) {
      for (const slider of sliders) slider.mark(names.includes(slider.dial.name))
      element.classList.toggle(
        'linked',
        sliders.some(({ dial }) => names.includes(dial.name)),
      )
    }
  }

  /** Applies the filter. While it is set, every group with a match is open; afterwards the groups are as before. */
  #apply(): void {
    const query = this.#filter.value.trim().toLowerCase()
    const filtering = query !== ''
    if (filtering && !this.#list.classList.contains('filtered')) this.#remember()
    let matches = 0
    for (const { element, count, sliders } of this.#groups) {
      const matching = sliders.filter(({ dial }) => dial.name.toLowerCase().includes(query))
      for (const slider of sliders) slider.row.hidden = !matching.includes(slider)
      count.textContent = String(matching.length)
      element.hidden = matching.length === 0
      element.open = filtering || this.#collapsed.get(element.dataset.name!) === false
      matches += matching.length
    }
    this.#list.classList.toggle('filtered', filtering)
    this.#found.textContent = filtering ? `${matches} found` : ''
  }

  #remember(): void {
    for (const { element } of this.#groups) this.#collapsed.set(element.dataset.name!, !element.open)
  }
}

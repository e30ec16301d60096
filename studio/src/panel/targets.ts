import { type Dial, groupDials } from '../dials.ts'
import { Slider } from './slider.ts'

interface Group {
  element: HTMLDetailsElement
  number: HTMLElement
  sliders: Slider[]
}

/** A slider per blendshape in groups that fold, with a filter by name. */
export class TargetsPanel {
  readonly #list: HTMLElement
  readonly #filter: HTMLInputElement
  readonly #count: HTMLElement
  readonly #onInput: (dial: Dial, value: number) => void
  readonly #onPoint: (dial: Dial | null) => void
  #groups: Group[] = []
  #folded = new Map<string, boolean>()

  constructor(
    list: HTMLElement,
    filter: HTMLInputElement,
    count: HTMLElement,
    onInput: (dial: Dial, value: number) => void,
    onPoint: (dial: Dial | null) => void,
  ) {
    this.#list = list
    this.#filter = filter
    this.#count = count
    this.#onInput = onInput
    this.#onPoint = onPoint
    filter.addEventListener('input', () => this.#apply())
  }

  show(dials: readonly Dial[]): void {
    if (!this.#list.classList.contains('filtered')) this.#remember()
    this.#groups = groupDials(dials).map((group) => {
      const element = document.createElement('details')
      const summary = document.createElement('summary')
      const number = document.createElement('span')
      summary.append(group.name, number)
      const sliders = group.dials.map((dial) => new Slider(dial, this.#onInput, this.#onPoint))
      element.append(summary, ...sliders.map(({ row }) => row))
      element.dataset.name = group.name
      element.open = this.#folded.get(group.name) === false
      return { element, number, sliders }
    })
    this.#list.replaceChildren(...this.#groups.map(({ element }) => element))
    this.#apply()
  }

  follow(): void {
    for (const { sliders } of this.#groups) for (const slider of sliders) slider.follow()
  }

  /** Marks the blendshapes that move something. */
  mark(names: readonly string[]): void {
    for (const { element, sliders } of this.#groups) {
      for (const slider of sliders) slider.mark(names.includes(slider.dial.name))
      element.classList.toggle(
        'linked',
        sliders.some(({ dial }) => names.includes(dial.name)),
      )
    }
  }

  /** While a filter is set every group with a match is unfolded; afterwards they are as they were. */
  #apply(): void {
    const wanted = this.#filter.value.trim().toLowerCase()
    const filtering = wanted !== ''
    if (filtering && !this.#list.classList.contains('filtered')) this.#remember()
    let found = 0
    for (const { element, number, sliders } of this.#groups) {
      const matching = sliders.filter(({ dial }) => dial.name.toLowerCase().includes(wanted))
      for (const slider of sliders) slider.row.hidden = !matching.includes(slider)
      number.textContent = String(matching.length)
      element.hidden = matching.length === 0
      element.open = filtering || this.#folded.get(element.dataset.name!) === false
      found += matching.length
    }
    this.#list.classList.toggle('filtered', filtering)
    this.#count.textContent = filtering ? `${found} found` : ''
  }

  #remember(): void {
    for (const { element } of this.#groups) this.#folded.set(element.dataset.name!, !element.open)
  }
}

import type { Dial } from '../dials.ts'

let count = 0

/** One labelled slider in a row, with its value beside it. */
export class Slider {
  readonly row = document.createElement('div')
  readonly dial: Dial
  readonly #input = document.createElement('input')
  readonly #output = document.createElement('output')
  #shown = Number.NaN

  constructor(dial: Dial, onInput: (dial: Dial, value: number) => void) {
    this.dial = dial
    const id = `slider-${++count}`
    const label = document.createElement('label')
    label.htmlFor = id
    label.textContent = dial.name
    label.title = dial.name
    Object.assign(this.#input, { id, type: 'range', min: '0', max: '1', step: '0.01' })
    this.#output.htmlFor.add(id)
    // The input says its own value; saying it again with every frame would drown all else.
    this.#output.ariaLive = 'off'
    this.#input.addEventListener('input', () => {
      onInput(dial, this.#input.valueAsNumber)
      this.follow()
    })
    this.row.className = 'row'
    this.row.append(label, this.#input, this.#output)
    this.follow()
  }

  /** Shows the value as it is now; touches the page only when it changed. */
  follow(): void {
    const value = this.dial.read()
    if (value === this.#shown) return
    this.#shown = value
    const text = value.toFixed(2)
    this.#input.value = text
    this.#input.style.setProperty('--value', text)
    this.#output.textContent = text
  }
}

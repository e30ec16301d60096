import type { Dial } from '../dials.ts'

let count = 0

/** One labelled slider in a row, with its value beside it. */
export class Slider {
  readonly row = document.createElement('div')
  readonly dial: Dial
  readonly #input = document.createElement('input')
  readonly #output = document.createElement('output')
  #shown = Number.NaN
  #pointed = false

  /** @param onPoint is told of the dial whose name is pointed at, and of null when it no longer is. */
  constructor(
    dial: Dial,
    onInput: (dial: Dial, value: number) => void,
    onPoint: (dial: Dial | null) => void,
  ) {
    this.dial = dial
    const id = `slider-${++count}`
    const label = document.createElement('label')
    label.htmlFor = id
    label.textContent = dial.name
    label.title = dial.name
    // A mouse that moves: a page that scrolls beneath it points at nothing, nor does a finger.
    label.addEventListener('pointermove', ({ pointerType, movementX, movementY }) => {
      if (this.#pointed || pointerType !== 'mouse' || (movementX === 0 && movementY === 0)) return
      this.#pointed = true
      onPoint(dial)
    })
    label.addEventListener('pointerleave', () => {
      if (this.#pointed) onPoint(null)
      this.#pointed = false
    })
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

  /** Shows whether it has to do with what is pointed at. */
  mark(linked: boolean): void {
    this.row.classList.toggle('linked', linked)
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

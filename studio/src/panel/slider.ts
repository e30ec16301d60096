import type { Dial } from '../viewer/dials.ts'

let count = 0

/** A row with a label, a slider and its value. */
export class Slider {
  readonly row = document.createElement('div')
  readonly dial: Dial
  readonly #input = document.createElement('input')
  readonly #output = document.createElement('output')
  #shown = Number.NaN
  #hovered = false

  /** @param onHover called with the dial when the mouse enters its label, and with null when it leaves. */
  constructor(
    dial: Dial,
    onInput: (dial: Dial, value: number) => void,
    onHover: (dial: Dial | null) => void,
  ) {
    this.dial = dial
    const id = `slider-${++count}`
    const label = document.createElement('label')
    label.htmlFor = id
    label.textContent = dial.name
    label.title = dial.name
    // Only a mouse that moves itself hovers, not one beneath which the page scrolls, nor a finger.
    label.addEventListener('pointermove', ({ pointerType, movementX, movementY }) => {
      if (this.#hovered || pointerType !== 'mouse' || (movementX === 0 && movementY === 0)) return
      this.#hovered = true
      onHover(dial)
    })
    label.addEventListener('pointerleave', () => {
      if (this.#hovered) onHover(null)
      this.#hovered = false
    })
    Object.assign(this.#input, { id, type: 'range', min: '0', max: '1', step: '0.01' })
    this.#output.htmlFor.add(id)
    // Screen readers announce the input's value; announcing the output too would drown everything else.
    this.#output.ariaLive = 'off'
    this.#input.addEventListener('input', () => {
      onInput(dial, this.#input.valueAsNumber)
      this.follow()
    })
    this.row.className = 'row'
    this.row.append(label, this.#input, this.#output)
    this.follow()
  }

  /** Shows whether the slider is linked to what is hovered. */
  mark(linked: boolean): void {
    this.row.classList.toggle('linked', linked)
  }

  /** Shows the current value; touches the page only if it has changed. */
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

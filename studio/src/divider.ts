const STEP = 0.02
const LEAP = 0.1

/** The line between the two sides: a slider for pointers and keys alike. */
export class Divider {
  readonly #element: HTMLElement
  readonly #stage: HTMLElement
  readonly #onMove: (share: number) => void
  #share = 0.5

  /** @param element role slider, placed by the custom property `--split` of `stage`. */
  constructor(element: HTMLElement, stage: HTMLElement, onMove: (share: number) => void) {
    this.#element = element
    this.#stage = stage
    this.#onMove = onMove
    element.addEventListener('pointerdown', this.#onGrab)
    element.addEventListener('keydown', this.#onKey)
    element.addEventListener('dblclick', () => this.move(0.5))
    this.move(0.5)
  }

  /** Share of the width without wrinkles, 0..1. */
  get share(): number {
    return this.#share
  }

  /** @param share of the width without wrinkles, clamped to 0..1. */
  move(share: number): void {
    this.#share = Math.min(1, Math.max(0, share))
    const percent = Math.round(this.#share * 100)
    this.#stage.style.setProperty('--split', `${this.#share * 100}%`)
    this.#element.ariaValueNow = String(percent)
    this.#element.ariaValueText = `${percent}% without, ${100 - percent}% with wrinkles`
    this.#onMove(this.#share)
  }

  readonly #onGrab = (event: PointerEvent): void => {
    if (event.button !== 0) return
    event.preventDefault()
    this.#element.focus({ preventScroll: true })
    this.#element.setPointerCapture(event.pointerId)
    const { left, width } = this.#stage.getBoundingClientRect()
    // Where it was grabbed it stays under the finger.
    const held = event.clientX - left - this.#share * width
    const drag = (move: PointerEvent) => this.move((move.clientX - left - held) / width)
    const drop = () => {
      this.#element.removeEventListener('pointermove', drag)
      this.#element.removeEventListener('lostpointercapture', drop)
    }
    this.#element.addEventListener('pointermove', drag)
    this.#element.addEventListener('lostpointercapture', drop)
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    const step = event.shiftKey ? LEAP : STEP
    const to: Record<string, number> = {
      ArrowLeft: this.#share - step,
      ArrowDown: this.#share - step,
      ArrowRight: this.#share + step,
      ArrowUp: this.#share + step,
      PageDown: this.#share - LEAP,
      PageUp: this.#share + LEAP,
      Home: 0,
      End: 1,
    }
    if (!(event.key in to)) return
    event.preventDefault()
    this.move(to[event.key])
  }
}

import { type ShortcutName, shortcutOf } from './shortcuts.ts'

/** Movement per key press, small and large, in fractions of the width. */
const STEP = 0.02
const LARGE_STEP = 0.1

/** Divider between the two sides, a slider for pointer and keyboard. */
export class Divider {
  readonly #element: HTMLElement
  readonly #stage: HTMLElement
  readonly #onMove: (position: number) => void
  #position = 0.5

  /** @param element element of role slider, positioned by the custom property `--split` of `stage`. */
  constructor(element: HTMLElement, stage: HTMLElement, onMove: (position: number) => void) {
    this.#element = element
    this.#stage = stage
    this.#onMove = onMove
    element.addEventListener('pointerdown', this.#onGrab)
    element.addEventListener('keydown', this.#onKey)
    element.addEventListener('dblclick', () => this.move(0.5))
    this.move(0.5)
  }

  /** Fraction of the width without wrinkles, 0..1. */
  get position(): number {
    return this.#position
  }

  /** @param position fraction of the width without wrinkles, clamped to 0..1. */
  move(position: number): void {
    this.#position = Math.min(1, Math.max(0, position))
    const percent = Math.round(this.#position * 100)
    this.#stage.style.setProperty('--split', `${this.#position * 100}%`)
    this.#element.ariaValueNow = String(percent)
    this.#element.ariaValueText = `${percent}% without, ${100 - percent}% with wrinkles`
    this.#onMove(this.#position)
  }

  readonly #onGrab = (event: PointerEvent): void => {
    if (event.button !== 0) return
    event.preventDefault()
    this.#element.focus({ preventScroll: true })
    this.#element.setPointerCapture(event.pointerId)
    const { left, width } = this.#stage.getBoundingClientRect()
    // Keeps the grabbed point of the line under the pointer.
    const grabOffset = event.clientX - left - this.#position * width
    const drag = (move: PointerEvent) => this.move((move.clientX - left - grabOffset) / width)
    const drop = () => {
      this.#element.removeEventListener('pointermove', drag)
      this.#element.removeEventListener('lostpointercapture', drop)
    }
    this.#element.addEventListener('pointermove', drag)
    this.#element.addEventListener('lostpointercapture', drop)
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    const to: Record<ShortcutName<'divider'>, number> = {
      left: this.#position - STEP,
      right: this.#position + STEP,
      farLeft: this.#position - LARGE_STEP,
      farRight: this.#position + LARGE_STEP,
      start: 0,
      end: 1,
    }
    const name = shortcutOf('divider', event)
    if (!name) return
    event.preventDefault()
    this.move(to[name])
  }
}

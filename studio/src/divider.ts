import { type ShortcutName, shortcutOf } from './shortcuts.ts'

/** Movement per key press, without and with Shift, in fractions of the stage's width. */
const STEP = 0.02
const LARGE_STEP = 0.1
/** Distance that `uncover` leaves, as a fraction of the stage's width. */
const MARGIN = 0.2

/** Divider on the stage: a vertical line. Left of it, the face is drawn without wrinkles. Pointer and keyboard move the divider. */
export class Divider {
  readonly #element: HTMLElement
  readonly #stage: HTMLElement
  readonly #onMove: (position: number) => void
  #position = 0.5

  /** @param element has the role `slider`. CSS positions it by the property `--split`, which this class sets on `stage`. */
  constructor(element: HTMLElement, stage: HTMLElement, onMove: (position: number) => void) {
    this.#element = element
    this.#stage = stage
    this.#onMove = onMove
    element.addEventListener('pointerdown', this.#onGrab)
    element.addEventListener('keydown', this.#onKey)
    element.addEventListener('dblclick', () => this.move(0.5))
    this.move(0.5)
  }

  /** Position of the divider, 0 (left edge of the stage) to 1 (right edge). */
  get position(): number {
    return this.#position
  }

  /** @param position position of the divider, clamped to 0..1. */
  move(position: number): void {
    this.#position = Math.min(1, Math.max(0, position))
    const percent = Math.round(this.#position * 100)
    this.#stage.style.setProperty('--split', `${this.#position * 100}%`)
    this.#element.ariaValueNow = String(percent)
    this.#element.ariaValueText = `${percent}% without, ${100 - percent}% with wrinkles`
    this.#onMove(this.#position)
  }

  /** Moves the divider to the left of a position, so that wrinkles there are seen. @param x 0 (left edge of the stage) to 1 (right edge). */
  uncover(x: number): void {
    if (this.#position > x - MARGIN) this.move(x - MARGIN)
  }

  readonly #onGrab = (event: PointerEvent): void => {
    if (event.button !== 0) return
    event.preventDefault()
    this.#element.focus({ preventScroll: true })
    this.#element.setPointerCapture(event.pointerId)
    const { left, width } = this.#stage.getBoundingClientRect()
    // Keep the distance between pointer and divider, so that the divider does not jump.
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

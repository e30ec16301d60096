import type { Camera } from 'three'
import { shortcutOf } from '../shortcuts.ts'
import { rayAt } from './ray-at.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** Gives pointers on the stage to the tool that is chosen, and to the camera where it does not take them. */
export class ToolHost {
  readonly #stage: HTMLElement
  readonly #camera: () => Camera | null
  #tool: StageTool | null = null
  /** The last event of the pointer that the tool has taken. */
  #taken: PointerEvent | null = null
  /** Whether the tool has begun with it. */
  #isBegun = false
  /** What the pointer does while the tool waits, to be done then; null where it does not wait. */
  #held: (() => void)[] | null = null

  /**
   * @param stage the element that the face is drawn on.
   * @param camera null where nothing is shown.
   */
  constructor(stage: HTMLElement, camera: () => Camera | null) {
    this.#stage = stage
    this.#camera = camera
    // Before the camera's own listeners.
    stage.addEventListener('pointerdown', this.#onDown, { capture: true })
    stage.addEventListener('pointermove', this.#onMove, { capture: true })
    stage.addEventListener('pointerup', this.#onUp, { capture: true })
    stage.addEventListener('pointercancel', () => this.cancel(), { capture: true })
    stage.addEventListener('pointerleave', () => this.#tool?.hover?.(null))
    addEventListener('keydown', (event) => shortcutOf('everywhere', event) === 'cancel' && this.cancel())
  }

  /** Ends the use of a tool where it is the chosen one. */
  leave(tool: StageTool): void {
    if (this.#tool === tool) this.choose(null)
  }

  /** Chooses a tool; null for the camera alone. */
  choose(tool: StageTool | null): void {
    this.cancel()
    this.#tool?.hover?.(null)
    this.#tool = tool
    this.#stage.classList.toggle('with-tool', tool !== null)
  }

  readonly #onDown = (event: PointerEvent): void => {
    if (this.#taken) {
      this.#meet(this.#taken, event)
      return
    }
    if (!this.#tool || event.button !== 0 || !event.isPrimary) return
    const pointer = this.#read(event)
    if (!pointer || !this.#begin(this.#tool, pointer)) return
    event.stopImmediatePropagation()
    event.preventDefault()
    this.#taken = event
    this.#stage.setPointerCapture(event.pointerId)
    this.#stage.focus({ preventScroll: true })
  }

  /** Returns whether the tool takes the pointer, for as long as it waits in any case. */
  #begin(tool: StageTool, pointer: StagePointer): boolean {
    const waiting = this.#held ? null : tool.waitsFor?.()
    if (waiting) this.#hold(waiting)
    const begin = () => {
      this.#isBegun = tool.begin(pointer)
    }
    if (this.#held) this.#held.push(begin)
    else begin()
    return this.#held !== null || this.#isBegun
  }

  #hold(waiting: Promise<unknown>): void {
    const held: (() => void)[] = []
    this.#held = held
    const go = () => {
      if (held !== this.#held) return
      this.#held = null
      for (const step of held) step()
    }
    waiting.then(go, go)
  }

  /** Goes on with what has begun, now or once the tool waits no more. */
  #goOn(step: () => void): void {
    const own = () => {
      if (this.#isBegun) step()
    }
    if (this.#held) this.#held.push(own)
    else own()
  }

  /** A second finger gives both to the camera, the first one as if it had come down only now. Of anything else the first one goes on. */
  #meet(taken: PointerEvent, second: PointerEvent): void {
    if (taken.pointerType !== 'touch' || second.pointerType !== 'touch') {
      second.stopImmediatePropagation()
      return
    }
    this.cancel()
    const { pointerId, pointerType, clientX, clientY } = taken
    const first = new PointerEvent('pointerdown', { pointerId, pointerType, clientX, clientY, bubbles: true })
    this.#stage.dispatchEvent(first)
  }

  readonly #onMove = (event: PointerEvent): void => {
    if (!this.#taken) {
      if (event.buttons === 0) this.#tool?.hover?.(this.#read(event))
      return
    }
    event.stopImmediatePropagation()
    if (event.pointerId !== this.#taken.pointerId) return
    this.#taken = event
    const events = event.getCoalescedEvents?.() ?? []
    const pointers = (events.length > 0 ? events : [event]).flatMap((each) => this.#read(each) ?? [])
    this.#goOn(() => this.#tool?.move(pointers))
  }

  readonly #onUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.#taken?.pointerId) return
    event.stopImmediatePropagation()
    this.#taken = null
    this.#goOn(() => this.#tool?.end())
  }

  /** Ends what the tool does without a result. */
  cancel(): void {
    this.#held = null
    if (!this.#taken) return
    this.#stage.releasePointerCapture(this.#taken.pointerId)
    this.#taken = null
    this.#tool?.cancel()
  }

  #read({ clientX, clientY, pointerType, pressure, shiftKey, altKey }: PointerEvent): StagePointer | null {
    const camera = this.#camera()
    const { left, top, width, height } = this.#stage.getBoundingClientRect()
    if (!camera || width === 0 || height === 0) return null
    const [x, y] = [clientX - left, clientY - top]
    return {
      ray: rayAt(camera, [x, y], [width, height]),
      // A mouse reports one half, which means nothing.
      pressure: pointerType === 'pen' ? pressure : 1,
      x,
      y,
      shift: shiftKey,
      alt: altKey,
    }
  }
}

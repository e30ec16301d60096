import type { Camera } from 'three'
import { shortcutOf } from '../shortcuts.ts'
import { rayAt } from './ray-at.ts'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** Routes pointer events on the stage to the chosen tool, or to the camera if the tool does not capture them. */
export class ToolHost {
  readonly #stage: HTMLElement
  readonly #camera: () => Camera | null
  #tool: StageTool | null = null
  /** Last event of the pointer that the tool has captured, or null. */
  #taken: PointerEvent | null = null
  /** Whether the tool has accepted the current gesture. */
  #isBegun = false
  /** Queued gesture steps while the tool is being prepared, otherwise null. */
  #queue: (() => void)[] | null = null

  /**
   * @param stage element that shows the face or its texture.
   * @param camera returns the camera, or null while no face is open.
   */
  constructor(stage: HTMLElement, camera: () => Camera | null) {
    this.#stage = stage
    this.#camera = camera
    // Listen in the capture phase, before the listeners of the camera controls.
    stage.addEventListener('pointerdown', this.#onDown, { capture: true })
    stage.addEventListener('pointermove', this.#onMove, { capture: true })
    stage.addEventListener('pointerup', this.#onUp, { capture: true })
    stage.addEventListener('pointercancel', () => this.cancel(), { capture: true })
    stage.addEventListener('pointerleave', () => this.#tool?.hover?.(null))
    addEventListener('keydown', (event) => shortcutOf('everywhere', event) === 'cancel' && this.cancel())
  }

  /** Deactivates a tool if it is the chosen one. */
  leave(tool: StageTool): void {
    if (this.#tool === tool) this.choose(null)
  }

  /** Chooses a tool, or null for the camera only. Choosing the same tool again does not end its gesture. */
  choose(tool: StageTool | null): void {
    if (tool === this.#tool) return
    this.cancel()
    this.#tool?.hover?.(null)
    this.#tool = tool
    this.#stage.classList.toggle('with-tool', tool !== null && !tool.isQuiet)
  }

  readonly #onDown = (event: PointerEvent): void => {
    if (this.#taken) {
      this.#addPointer(this.#taken, event)
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

  /** Begins a gesture, or queues it while the tool is being prepared. Returns whether to capture the pointer. */
  #begin(tool: StageTool, pointer: StagePointer): boolean {
    const waiting = this.#queue ? null : tool.preparation?.()
    if (waiting) this.#queueUntil(waiting)
    const begin = () => {
      this.#isBegun = tool.begin(pointer)
    }
    if (this.#queue) this.#queue.push(begin)
    else begin()
    return this.#queue !== null || this.#isBegun
  }

  #queueUntil(waiting: Promise<unknown>): void {
    const queue: (() => void)[] = []
    this.#queue = queue
    const flush = () => {
      if (queue !== this.#queue) return
      this.#queue = null
      for (const step of queue) step()
    }
    waiting.then(flush, flush)
  }

  /** Runs a step of the gesture if the tool has accepted the gesture. While the tool is being prepared, queues the step. */
  #continue(step: () => void): void {
    const own = () => {
      if (this.#isBegun) step()
    }
    if (this.#queue) this.#queue.push(own)
    else own()
  }

  /**
   * Handles a second pointer during a gesture. A second touch cancels the gesture, and both touches move the camera. The camera controls have not
   * received the press of the first touch, so this method dispatches the press again. Other pointers are ignored.
   */
  #addPointer(taken: PointerEvent, second: PointerEvent): void {
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
    this.#continue(() => this.#tool?.move(pointers))
  }

  readonly #onUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.#taken?.pointerId) return
    event.stopImmediatePropagation()
    this.#taken = null
    this.#continue(() => this.#tool?.end())
  }

  cancel(): void {
    this.#queue = null
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
      // A mouse always reports a pressure of 0.5.
      pressure: pointerType === 'pen' ? pressure : 1,
      x,
      y,
      shift: shiftKey,
      alt: altKey,
    }
  }
}

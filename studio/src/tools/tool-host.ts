import { type Camera, Ray, Raycaster, Vector2 } from 'three'
import type { StagePointer, StageTool } from './stage-tool.ts'

/** Gives pointers on the stage to the tool that is chosen, and to the camera where it does not take them. */
export class ToolHost {
  readonly #stage: HTMLElement
  readonly #camera: () => Camera | null
  #tool: StageTool | null = null
  #pointer: number | null = null

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
    stage.addEventListener('pointercancel', () => this.#cancel(), { capture: true })
    stage.addEventListener('pointerleave', () => this.#tool?.hover?.(null))
    addEventListener('keydown', ({ key }) => key === 'Escape' && this.#cancel())
  }

  /** Chooses a tool; null for the camera alone. */
  choose(tool: StageTool | null): void {
    this.#cancel()
    this.#tool?.hover?.(null)
    this.#tool = tool
    this.#stage.classList.toggle('with-tool', tool !== null)
  }

  readonly #onDown = (event: PointerEvent): void => {
    if (this.#pointer !== null) {
      event.stopImmediatePropagation()
      return
    }
    if (!this.#tool || event.button !== 0) return
    const pointer = this.#read(event)
    if (!pointer || !this.#tool.begin(pointer)) return
    event.stopImmediatePropagation()
    event.preventDefault()
    this.#pointer = event.pointerId
    this.#stage.setPointerCapture(event.pointerId)
    this.#stage.focus({ preventScroll: true })
  }

  readonly #onMove = (event: PointerEvent): void => {
    if (this.#pointer === null) {
      if (event.buttons === 0) this.#tool?.hover?.(this.#read(event))
      return
    }
    event.stopImmediatePropagation()
    if (event.pointerId !== this.#pointer) return
    const events = event.getCoalescedEvents?.() ?? []
    const pointers = (events.length > 0 ? events : [event]).flatMap((each) => this.#read(each) ?? [])
    this.#tool?.move(pointers)
  }

  readonly #onUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.#pointer) return
    event.stopImmediatePropagation()
    this.#pointer = null
    this.#tool?.end()
  }

  #cancel(): void {
    if (this.#pointer === null) return
    this.#stage.releasePointerCapture(this.#pointer)
    this.#pointer = null
    this.#tool?.cancel()
  }

  #read({ clientX, clientY, pointerType, pressure, shiftKey, altKey }: PointerEvent): StagePointer | null {
    const camera = this.#camera()
    const { left, top, width, height } = this.#stage.getBoundingClientRect()
    if (!camera || width === 0 || height === 0) return null
    const [x, y] = [clientX - left, clientY - top]
    const caster = new Raycaster()
    caster.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), camera)
    return {
      ray: new Ray().copy(caster.ray),
      // A mouse reports one half, which means nothing.
      pressure: pointerType === 'pen' ? pressure : 1,
      x,
      y,
      shift: shiftKey,
      alt: altKey,
    }
  }
}

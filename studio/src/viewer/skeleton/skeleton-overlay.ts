import { effect, type ReadonlySignal, type Signal, signal } from '@preact/signals'
import { Vector3 } from 'three'
import { type ShortcutName, shortcutOf } from '../../shortcuts.ts'
import type { Viewer } from '../viewer.ts'
import { handlesOf, type JointHandle, turnTowards } from './joint-handles.ts'

/** Rotation per key press, without and with Shift, radians. */
const STEP = Math.PI / 36
const LARGE_STEP = Math.PI / 12
/** Radius of a handle, CSS pixels. */
const RADIUS = 5
/** Minimum length of a bone on the screen that a drag turns, CSS pixels. Shorter ones point at the camera. */
const MIN_LENGTH = 4

export interface SkeletonOverlayParts {
  /** Element that shows the face. */
  stage: HTMLElement
  viewer: ReadonlySignal<Viewer | null>
  /** Changes the pose of the face, and stops other motion. */
  set(write: () => void): void
  wake(): void
  label: string
  /** Returns the everyday name of a joint. */
  nameOf(joint: string): string
}

/** Draws the skeleton of the avatar over the stage: bones as lines, and a handle at the end of each bone that turns it. */
export class SkeletonOverlay {
  readonly isOn: Signal<boolean> = signal(false)
  readonly #parts: SkeletonOverlayParts
  readonly #svg = svgElement('svg', { class: 'skeleton', role: 'group', hidden: '' })
  #handles: readonly { handle: JointHandle; line: SVGElement; dot: SVGElement }[] = []

  constructor(parts: SkeletonOverlayParts) {
    this.#parts = parts
    this.#svg.ariaLabel = parts.label
    parts.stage.after(this.#svg)
    effect(() => {
      const viewer = parts.viewer.value
      const isShown = this.isOn.value && viewer !== null
      this.#svg.toggleAttribute('hidden', !isShown)
      this.#handles = isShown ? this.#create(viewer) : []
      this.#svg.replaceChildren(
        ...this.#handles.map(({ line }) => line),
        ...this.#handles.map(({ dot }) => dot),
      )
      parts.wake()
    })
  }

  /** Moves lines and handles to the joints. */
  draw(): void {
    if (this.#handles.length === 0) return
    for (const { handle, line, dot } of this.#handles) {
      const [from, to] = this.#bone(handle)
      const isSeen = from.z < 1 && to.z < 1
      line.toggleAttribute('hidden', !isSeen)
      dot.toggleAttribute('hidden', !isSeen)
      setAll(line, { x1: from.x, y1: from.y, x2: to.x, y2: to.y })
      setAll(dot, { cx: to.x, cy: to.y })
    }
  }

  #create({ skeleton, avatar }: Viewer) {
    avatar.root.updateMatrixWorld()
    return handlesOf(skeleton.joints).map((handle, i) => {
      const line = svgElement('line', {})
      const dot = svgElement('circle', { r: `${RADIUS}`, role: 'button', tabindex: i === 0 ? '0' : '-1' })
      dot.ariaLabel = this.#parts.nameOf(handle.name)
      dot.addEventListener('pointerdown', (event) => this.#grab(handle, dot, event))
      dot.addEventListener('keydown', (event) => this.#onKey(handle, i, event))
      return { handle, line, dot }
    })
  }

  /** Returns both ends of a bone on the stage, CSS pixels. `z` is at least 1 behind the camera. */
  #bone(handle: JointHandle): [Vector3, Vector3] {
    const { stage, viewer } = this.#parts
    const { camera } = viewer.peek()!.stage
    const ends = [new Vector3().setFromMatrixPosition(handle.turned.matrixWorld), handle.read(new Vector3())]
    const [from, to] = ends.map((end) => {
      const { x, y, z } = end.project(camera)
      return new Vector3(((x + 1) / 2) * stage.clientWidth, ((1 - y) / 2) * stage.clientHeight, z)
    })
    return [from, to]
  }

  #grab(handle: JointHandle, dot: SVGElement, event: PointerEvent): void {
    if (event.button !== 0) return
    event.preventDefault()
    this.#focus(dot)
    dot.setPointerCapture(event.pointerId)
    const drag = ({ clientX, clientY }: PointerEvent) => {
      const { left, top } = this.#parts.stage.getBoundingClientRect()
      const [from, to] = this.#bone(handle)
      const [x, y] = [clientX - left - from.x, clientY - top - from.y]
      if (Math.min(Math.hypot(x, y), Math.hypot(to.x - from.x, to.y - from.y)) < MIN_LENGTH) return
      // The y axis of the screen points down, so that angles are clockwise.
      this.#turn(handle, Math.atan2(to.y - from.y, to.x - from.x) - Math.atan2(y, x))
    }
    const drop = () => {
      dot.removeEventListener('pointermove', drag)
      dot.removeEventListener('lostpointercapture', drop)
    }
    dot.addEventListener('pointermove', drag)
    dot.addEventListener('lostpointercapture', drop)
  }

  #onKey(handle: JointHandle, index: number, event: KeyboardEvent): void {
    const step = event.shiftKey ? LARGE_STEP : STEP
    const choose = (next: number) => {
      const other = this.#handles[next]
      if (other) this.#focus(other.dot)
    }
    const actions: Record<ShortcutName<'skeleton'>, () => void> = {
      left: () => this.#turn(handle, step),
      right: () => this.#turn(handle, -step),
      up: () => choose(index - 1),
      down: () => choose(index + 1),
    }
    const name = shortcutOf('skeleton', event)
    if (!name) return
    actions[name]()
    event.preventDefault()
    event.stopPropagation()
  }

  /** Moves the focus, and the stop of the tab key, to a handle. */
  #focus(dot: SVGElement): void {
    for (const each of this.#handles) each.dot.setAttribute('tabindex', each.dot === dot ? '0' : '-1')
    dot.focus({ preventScroll: true })
  }

  #turn({ turned }: JointHandle, angle: number): void {
    const { viewer, set } = this.#parts
    const shown = viewer.peek()
    if (shown) set(() => shown.move(() => turnTowards(turned, shown.stage.camera, angle)))
  }
}

function svgElement(name: string, attributes: Record<string, string>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name)
  for (const [attribute, value] of Object.entries(attributes)) element.setAttribute(attribute, value)
  return element
}

function setAll(element: SVGElement, numbers: Record<string, number>): void {
  for (const [name, value] of Object.entries(numbers)) element.setAttribute(name, value.toFixed(1))
}

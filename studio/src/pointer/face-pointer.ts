import { areaAt } from '../document/area-at.ts'
import type { Lines } from '../lines/lines.ts'
import type { SkinHit } from '../paint/picker.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'
import type { ShownFace } from '../viewer/shown-face.ts'

/** Maximum distance between press and release of a click, CSS pixels. */
const CLICK = 4

export interface FacePointerParts {
  /** Element that shows the face. */
  stage: HTMLElement
  session: Session
  face: ShownFace
  areas: AreaEditor
  lines: () => Lines
  /** Makes the wrinkles of the avatar's file editable. */
  edit(): void
}

/** Lets the pointer use the face as an interface: pointing at a region shows it, and a click chooses it. */
export class FacePointer {
  readonly #parts: FacePointerParts

  constructor(parts: FacePointerParts) {
    this.#parts = parts
    const { stage } = parts
    let pressed: PointerEvent | null = null
    // Tools that capture the pointer stop these events.
    stage.addEventListener('pointerdown', (event) => {
      pressed = event.button === 0 && event.isPrimary ? event : null
      this.point(null)
    })
    stage.addEventListener('pointerup', (event) => {
      const start = pressed
      pressed = null
      if (!start || event.pointerId !== start.pointerId) return
      if (Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) <= CLICK)
        void this.#click(event)
    })
  }

  /** Shows the region at a point of the skin. Null ends that. */
  point(hit: SkinHit | null): void {
    const { session, face } = this.#parts
    const document = session.document.peek()
    const name = hit && document && areaAt(document.areas, hit.uv)
    const shown = face.hovered.peek()
    if (name === (shown?.isOnFace ? shown.name : null)) return
    if (name) face.hovered.value = { kind: 'area', name, isOnFace: true }
    else if (shown?.isOnFace) face.hovered.value = null
  }

  /** Chooses the region at the pointer. The first click on a face waits until its skin is ready. */
  async #click({ clientX, clientY }: PointerEvent): Promise<void> {
    const { stage, session, areas, lines, edit } = this.#parts
    if (lines().editor.mode.peek() !== 'select') return
    if (!session.document.peek()) {
      edit()
      return
    }
    await lines().preparation()
    const document = session.document.peek()
    if (!document) return
    const { left, top } = stage.getBoundingClientRect()
    const hit = lines().pickAt(clientX - left, clientY - top)
    lines().editor.choose(null)
    areas.choose(hit ? areaAt(document.areas, hit.uv) : null)
  }
}

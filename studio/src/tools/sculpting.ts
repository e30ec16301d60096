import { effect, type ReadonlySignal, signal } from '@preact/signals'
import type { Ray } from 'three'
import type { StudioDocument } from '../document/document.ts'
import { sculptedOn, setSculpted } from '../document/layers.ts'
import { type HeightImage, imageOf, type Rectangle, sculptedSize, withImage } from '../document/sculpted.ts'
import { addSculptedLayer, coverSculpted, type SculptPlace, sculptPlace } from '../document/sculpted-area.ts'
import { otherSide } from '../document/sides.ts'
import { STEP } from '../labels/steps.ts'
import { resized } from '../paint/brush.ts'
import { visibleRadius } from '../paint/dab-size.ts'
import type { SkinHit } from '../paint/picker.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'
import { shortcutOf } from '../shortcuts.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { BrushRing } from './brush-ring.ts'
import type { FaceSkin } from './face-skin.ts'
import { type PaintTarget, PaintTool } from './paint-tool.ts'
import { RevealedAreas } from './revealed-areas.ts'
import { brushOf, SCULPT_DEFAULTS, type SculptSettings } from './sculpt-settings.ts'
import type { ToolHost } from './tool-host.ts'

/** Sculpted heights of a layer, and where the stroke belongs. */
interface SculptTarget extends PaintTarget<HeightImage> {
  readonly place: SculptPlace
}

export interface SculptingParts {
  session: Session
  areas: AreaEditor
  viewer: ReadonlySignal<Viewer | null>
  face: FaceSkin
  host: ToolHost
  /** Element over which the outline of the brush is drawn. */
  stage: HTMLElement
  /** Requests the next frame. */
  wake(): void
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** Lets brushes sculpt the heights of a layer. A stroke changes the document in every frame, and is one undo step. */
export class Sculpting {
  readonly #parts: SculptingParts
  readonly #tools: { tool: PaintTool<SculptTarget>; host: ToolHost }[] = []
  readonly #ring: BrushRing
  readonly #hit = signal<SkinHit | null>(null)
  readonly #revealed: RevealedAreas
  /** Document that the current stroke has made, or null before its first change. */
  #made: StudioDocument | null = null
  #isEditing = false

  readonly isOn = signal(false)
  readonly settings = signal<SculptSettings>(SCULPT_DEFAULTS)

  constructor(parts: SculptingParts) {
    this.#parts = parts
    const { session, viewer } = parts
    this.#ring = new BrushRing(parts.stage)
    this.#revealed = new RevealedAreas(viewer)
    this.#addTool(parts.host, (ray) => this.#targetOnFace(ray))
    effect(() => {
      if (!this.isOn.value) this.#revealed.end()
      else void this.#preparation()
    })
    // Cancel the stroke if something else changes the document, for example undo.
    effect(() => {
      session.document.value
      if (this.isOn.peek() && !this.#isEditing) for (const { host } of this.#tools) host.cancel()
    })
    effect(() => {
      this.settings.value
      parts.wake()
    })
    addEventListener('keydown', (event) => this.#onKey(event))
  }

  /** Brush position on the skin, or null. */
  get hit(): ReadonlySignal<SkinHit | null> {
    return this.#hit
  }

  /** Adds a tool for sculpting on the texture. @param host tool host whose rays come from the texture camera. */
  addTexture(host: ToolHost): void {
    this.#addTool(host, (ray) => this.#targetOnTexture(ray))
  }

  /** Shows the current stroke and updates the outline. Call before each frame. */
  advance(): void {
    for (const { tool } of this.#tools) tool.showStroke()
    this.#drawRing()
  }

  #addTool(host: ToolHost, target: (ray: Ray) => SculptTarget | null): void {
    const { wake, session, attempt } = this.#parts
    const tool = new PaintTool<SculptTarget>({
      target,
      preparation: () => this.#preparation(),
      onPaint: wake,
      show: (stroke, image, changed) => void attempt(() => this.#edit(stroke, image, changed)),
      keep: (stroke, image, changed) => {
        attempt(() => this.#edit(stroke, image, changed))
        this.#made = null
        session.settle()
      },
      discard: () => {
        const isLast = this.#made !== null && this.#made === session.document.peek()
        this.#made = null
        session.settle()
        if (isLast) session.undo()
        wake()
      },
      onHit: (hit) => {
        this.#hit.value = hit
        this.#drawRing()
      },
    })
    this.#tools.push({ tool, host })
    effect(() => {
      if (this.isOn.value) host.choose(tool)
      else host.leave(tool)
    })
  }

  #edit({ name, place, image: before }: SculptTarget, image: HeightImage, changed: Rectangle): void {
    const { session, areas } = this.#parts
    const isNew = !session.document.peek()?.areas.some((area) => area.name === place.area)
    this.#isEditing = true
    try {
      session.edit(
        STEP.sculpt,
        (document) => {
          const heights = withImage(sculptedOn(document, name), image, changed)
          const sculpted = setSculpted(addSculptedLayer(document, place), name, heights)
          return coverSculpted(sculpted, place, before, image, changed)
        },
        'sculpt',
      )
    } finally {
      this.#isEditing = false
    }
    const document = session.document.peek()
    this.#made = document
    if (isNew && document?.areas.some((area) => area.name === place.area)) areas.askWhen(place.area)
    this.#revealed.show(this.settings.peek().mirror ? [place.area, otherSide(place.area)] : [place.area])
  }

  #targetOnFace(ray: Ray): SculptTarget | null {
    const [viewer, face] = [this.#parts.viewer.peek(), this.#face()]
    if (!viewer || !face) return null
    const { skin, picker } = face
    return this.#targetAt(picker.pick(ray), {
      skin,
      picker,
      sight: picker.sightFrom(viewer.stage.camera.position),
    })
  }

  /** Returns a target without a visibility test, because sculpting on the texture includes hidden skin. */
  #targetOnTexture(ray: Ray): SculptTarget | null {
    const face = this.#face()
    return face && this.#targetAt(face.texture.pick(ray), { skin: face.skin, picker: face.texture })
  }

  #targetAt(
    hit: SkinHit | undefined,
    skin: Pick<SculptTarget, 'skin' | 'picker' | 'sight'>,
  ): SculptTarget | null {
    const { session, areas } = this.#parts
    const document = session.document.peek()
    if (!document || !hit) return null
    const place = sculptPlace(document, areas.chosen.peek(), hit.uv)
    const sculpted = sculptedOn(document, place.layer)
    let image: HeightImage | undefined
    return {
      ...skin,
      name: place.layer,
      place,
      brush: brushOf(this.settings.peek()),
      // The image is large, and hovering does not need it.
      get image() {
        image ??= imageOf(sculpted)
        return image
      },
    }
  }

  get #size(): number {
    return sculptedSize(this.#parts.session.document.peek()?.mapSize ?? 0)
  }

  #face() {
    return this.#parts.face.open && this.#parts.face.at(this.#size)
  }

  #preparation(): Promise<unknown> | null {
    return this.#parts.face.open && this.#parts.face.preparation(this.#size)
  }

  #drawRing(): void {
    const { viewer, session } = this.#parts
    this.#ring.update({
      hit: this.#hit.peek(),
      viewer: viewer.peek(),
      document: session.document.peek(),
      radiusAt: (hit) => this.ringRadius(hit),
    })
  }

  /** Returns the radius of the brush outline at a point of the skin, millimetres. It shows the true size of a dab. */
  ringRadius({ triangle }: Pick<SkinHit, 'triangle'>): number {
    const [brush, skin] = [this.settings.peek(), this.#face()?.skin]
    return skin ? visibleRadius(skin.mapOf(this.#size), brush, triangle) : brush.radius
  }

  #onKey(event: KeyboardEvent): void {
    const name = shortcutOf('painting', event)
    if (!this.isOn.peek() || !name) return
    const { mode, radius } = this.settings.peek()
    const change: Partial<SculptSettings> =
      name === 'swap' ? { mode: mode === 'raise' ? 'lower' : 'raise' } : { radius: resized(radius, name) }
    this.settings.value = { ...this.settings.peek(), ...change }
  }
}

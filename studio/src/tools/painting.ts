import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import type { GrayImage } from 'furrow'
import { updateArea } from 'furrow/three'
import { paintArea } from '../document/areas.ts'
import type { StudioDocument } from '../document/document.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import { BRUSH_DEFAULTS, BRUSH_RADII, type Brush } from '../paint/brush.ts'
import { PaintSkin } from '../paint/paint-skin.ts'
import { type SkinHit, SkinPicker } from '../paint/picker.ts'
import { readSkin } from '../paint/read-skin.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'
import { type ShortcutName, shortcutOf } from '../shortcuts.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { BrushRing } from './brush-ring.ts'
import { type PaintTarget, PaintTool } from './paint-tool.ts'
import type { ToolHost } from './tool-host.ts'

/** Factor on the brush's radius per key press. */
const SIZE_STEP = 1.15

/** A face that is painted on, in the pose that it had when the picker was made or refitted last. */
interface PaintedFace {
  readonly root: OpenedAvatar['root']
  readonly index: number
  readonly scale: number
  readonly skin: PaintSkin
  readonly picker: SkinPicker
}

export interface PaintingParts {
  session: Session
  areas: AreaEditor
  viewer: ReadonlySignal<Viewer | null>
  /** Changes whenever the pose may have changed. */
  frame: ReadonlySignal<number>
  host: ToolHost
  /** The element over which the brush is outlined. */
  stage: HTMLElement
  /** Requests the next frame. */
  wake(): void
}

/** Painting of the chosen area on the face: whether the tool is in use, its brush, and what it changes. */
export class Painting {
  readonly #parts: PaintingParts
  readonly #isOn = signal(false)
  readonly #tool: PaintTool
  readonly #ring: BrushRing
  #face: PaintedFace | null = null
  #isPoseNew = true
  #hit: SkinHit | null = null

  readonly brush = signal<Brush>(BRUSH_DEFAULTS)
  /** Whether skin that the camera does not see is painted as well. */
  readonly isThrough = signal(false)
  /** Name of the area that is painted; null while the tool is not in use. */
  readonly area: ReadonlySignal<string | null> = computed(() =>
    this.#isOn.value ? (this.#parts.areas.chosen.value?.name ?? null) : null,
  )

  constructor(parts: PaintingParts) {
    this.#parts = parts
    const { session, areas, viewer, frame, host } = parts
    this.#ring = new BrushRing(parts.stage)
    this.#tool = new PaintTool({
      target: () => this.#target(),
      onPaint: parts.wake,
      show: (area, weights) => this.#show(area, weights),
      keep: (area, weights) => session.edit(`Paint ${area}`, (old) => paintArea(old, area, weights)),
      onHit: (hit) => {
        this.#hit = hit
        this.#drawRing()
      },
    })
    effect(() => {
      if (!areas.chosen.value) this.#isOn.value = false
    })
    effect(() => {
      viewer.value
      if (this.area.value === null) host.leave(this.#tool)
      else host.choose(this.#tool)
    })
    // A stroke goes on from weights that undo has replaced.
    effect(() => {
      session.document.value
      if (this.area.peek() !== null) host.cancel()
    })
    effect(() => {
      frame.value
      this.#isPoseNew = true
    })
    effect(() => {
      this.brush.value
      parts.wake()
    })
    addEventListener('keydown', (event) => this.#onKey(event))
  }

  /** Begins or ends painting. */
  set isOn(isOn: boolean) {
    this.#isOn.value = isOn
  }

  /** Before a frame is drawn. */
  advance(): void {
    this.#tool.showStroke()
    this.#drawRing()
  }

  #target(): PaintTarget | null {
    const [viewer, document] = [this.#parts.viewer.peek(), this.#parts.session.document.peek()]
    const area = this.#parts.areas.chosen.peek()
    if (!viewer || !document || !area) return null
    const { skin, picker } = this.#faceOf(viewer.avatar, document)
    const eye = viewer.stage.camera.position
    const sight = this.isThrough.peek() ? undefined : picker.sightFrom(eye)
    return { area, brush: this.brush.peek(), skin, picker, sight }
  }

  /** The face as it is posed now. */
  #faceOf({ root, skins, skin: index }: OpenedAvatar, document: StudioDocument): PaintedFace {
    const { scale, areaSize } = document
    const known = this.#face
    if (known?.root !== root || known.index !== index || known.scale !== scale) {
      const meshes = readSkin(skins[index].meshes)
      const skin = new PaintSkin(meshes.skin, scale)
      // Now rather than when the first stroke begins.
      skin.mapOf(areaSize)
      this.#face = { root, index, scale, skin, picker: new SkinPicker(meshes, skin) }
    } else if (this.#isPoseNew) known.picker.refit()
    this.#isPoseNew = false
    return this.#face!
  }

  #show(area: string, weights: GrayImage): void {
    const wrinkles = this.#parts.viewer.peek()?.wrinkles
    if (wrinkles?.hasArea(area)) updateArea(wrinkles, area, weights)
  }

  #drawRing(): void {
    const [viewer, document] = [this.#parts.viewer.peek(), this.#parts.session.document.peek()]
    if (!this.#hit || !viewer || !document) {
      this.#ring.hide()
      return
    }
    const { point, normal } = this.#hit
    this.#ring.show(point, normal, this.brush.peek().radius / document.scale, viewer.stage.camera)
  }

  #onKey(event: KeyboardEvent): void {
    const name = shortcutOf('painting', event)
    if (this.area.peek() === null || !name) return
    const { mode, radius } = this.brush.peek()
    const [least, most] = BRUSH_RADII
    const resize = (factor: number) => ({ radius: Math.min(Math.max(radius * factor, least), most) })
    const changes: Record<ShortcutName<'painting'>, () => Partial<Brush>> = {
      smaller: () => resize(1 / SIZE_STEP),
      larger: () => resize(SIZE_STEP),
      exchange: () => ({ mode: mode === 'add' ? 'remove' : 'add' }),
    }
    this.brush.value = { ...this.brush.peek(), ...changes[name]() }
  }
}

import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import type { GrayImage } from 'furrow'
import { updateArea } from 'furrow/three'
import { Vector3 } from 'three'
import { paintArea } from '../document/areas.ts'
import type { StudioDocument } from '../document/document.ts'
import { runInTurn } from '../later.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import { BRUSH_DEFAULTS, BRUSH_RADII, type Brush } from '../paint/brush.ts'
import { mirrorWeights } from '../paint/mirror-weights.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import type { SkinHit, SkinPicker } from '../paint/picker.ts'
import { posedSkinOf, preparedSkin, prepareSkin } from '../paint/posed-skin.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'
import { type ShortcutName, shortcutOf } from '../shortcuts.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { BrushRing } from './brush-ring.ts'
import { type PaintTarget, PaintTool } from './paint-tool.ts'
import { PolygonPainting } from './polygon-painting.ts'
import type { StageTool } from './stage-tool.ts'
import type { TextureCamera } from './texture-camera.ts'
import { TexturePicker } from './texture-picker.ts'
import type { ToolHost } from './tool-host.ts'

/** Factor on the brush's radius per key press. */
const SIZE_STEP = 1.15

/** A face that is painted on, in its present pose. */
interface PaintedFace {
  readonly skin: PaintSkin
  readonly picker: SkinPicker
  readonly texture: TexturePicker
}

/** What the skin of the open face is made of. */
type OpenFace = Pick<StudioDocument, 'scale' | 'areaSize'> & Pick<OpenedAvatar['skins'][number], 'meshes'>

/** Vertices of the largest skin that is made before it is needed: a larger one takes hundreds of megabytes, perhaps for nothing. */
const MOST_PREPARED = 500_000

export const PAINT_SHAPES = ['brush', 'polygon'] as const
export type PaintShape = (typeof PAINT_SHAPES)[number]

export interface PaintingParts {
  session: Session
  areas: AreaEditor
  viewer: ReadonlySignal<Viewer | null>
  host: ToolHost
  /** The element over which the brush is outlined. */
  stage: HTMLElement
  /** Requests the next frame. */
  wake(): void
  /** Runs a task, and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** Painting of the chosen area on the face: whether the tool is in use, its brush, and what it changes. */
export class Painting {
  readonly #parts: PaintingParts
  readonly #isOn = signal(false)
  /** Each with what gives it pointers: the face's, and the texture's where that is shown. */
  readonly #tools: { tool: PaintTool; host: ToolHost }[] = []
  readonly #ring: BrushRing
  readonly #hit = signal<SkinHit | null>(null)
  readonly #stroke = signal<GrayImage | null>(null)
  readonly #made = signal(0)

  readonly brush = signal<Brush>(BRUSH_DEFAULTS)
  /** What paints on the face. */
  readonly shape = signal<PaintShape>('brush')
  readonly polygon: PolygonPainting
  /** Whether skin that the camera does not see is painted as well. */
  readonly isThrough = signal(false)
  /** Name of the area that is painted; null while the tool is not in use. */
  readonly area: ReadonlySignal<string | null> = computed(() =>
    this.#isOn.value ? (this.#parts.areas.chosen.value?.name ?? null) : null,
  )

  constructor(parts: PaintingParts) {
    this.#parts = parts
    const { session, areas, host } = parts
    this.#ring = new BrushRing(parts.stage)
    this.#addTool(host, () => this.#targetOnFace(), 'brush')
    this.polygon = new PolygonPainting({
      ...parts,
      brush: this.brush,
      waitsFor: () => this.#waitsFor(),
      keep: (area, weights) => this.#keep(area, weights),
    })
    const onFace = this.polygon.addView({
      element: parts.stage,
      camera: () => parts.viewer.peek()?.stage.camera ?? null,
      target: () => this.#targetOnFace(),
      positionOf: ({ triangle, weights }) =>
        this.#face()?.picker.positionOf(triangle, weights, new Vector3()) ?? null,
    })
    this.#offer(host, onFace, 'polygon')
    effect(() => {
      if (this.area.value === null || this.shape.value !== 'polygon') this.polygon.clear()
    })
    effect(() => {
      if (!areas.chosen.value) this.#isOn.value = false
    })
    this.#prepareSkins()
    effect(() => {
      if (this.area.value !== null) void this.#waitsFor()
    })
    // A stroke goes on from weights that undo has replaced.
    effect(() => {
      session.document.value
      if (this.area.peek() !== null) for (const { host } of this.#tools) host.cancel()
      this.#stroke.value = null
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

  /** Where the brush is on the skin; null off it. */
  get hit(): ReadonlySignal<SkinHit | null> {
    return this.#hit
  }

  /** The weights that the present stroke has made, anew whenever they changed; null between strokes. */
  get stroke(): ReadonlySignal<GrayImage | null> {
    return this.#stroke
  }

  /** The skin that is painted on; null where nothing is open, and until it is made. */
  get skin(): PaintSkin | null {
    return this.#face()?.skin ?? null
  }

  /** Changes whenever a skin was made. */
  get made(): ReadonlySignal<number> {
    return this.#made
  }

  /**
   * Lets the texture be painted as well.
   *
   * @param host whose rays are those of the camera.
   * @param element that shows the texture as the camera sees it.
   */
  addTexture(host: ToolHost, element: HTMLElement, { camera }: TextureCamera): void {
    const target = () => this.#targetOnTexture()
    this.#addTool(host, target, 'brush')
    const positionOf = ({ uv: [u, v] }: SkinHit) => new Vector3(u, -v, 0)
    this.#offer(host, this.polygon.addView({ element, camera: () => camera, target, positionOf }), 'polygon')
  }

  /** The mirror image of weights on the face that is open. */
  mirrored(weights: GrayImage): GrayImage {
    const open = this.#open()
    return open ? mirrorWeights(weights, posedSkinOf(open.meshes, open.scale).skin) : weights
  }

  /** Before a frame is drawn. */
  advance(): void {
    for (const { tool } of this.#tools) tool.showStroke()
    this.#drawRing()
    this.polygon.advance()
  }

  /** Makes the skin of each face ready before it is painted, but for those whose making takes hundreds of megabytes. Where that fails, painting tells why. */
  #prepareSkins(): void {
    const { viewer, session } = this.#parts
    const avatar = computed(() => viewer.value?.avatar)
    const scale = computed(() => session.document.value?.scale)
    const size = computed(() => session.document.value?.areaSize)
    effect(() => {
      avatar.value
      scale.value
      size.value
      const open = this.#open()
      if (!open || isLarge(open.meshes)) return
      return runInTurn(() => void this.#prepare(open).catch(() => {}))
    })
  }

  async #prepare({ meshes, scale, areaSize }: OpenFace): Promise<void> {
    await prepareSkin(meshes, scale, areaSize)
    this.#made.value++
    this.#parts.wake()
  }

  /** What makes the skin; null once it is made. */
  #waitsFor(): Promise<unknown> | null {
    const open = this.#open()
    if (!open || preparedSkin(open.meshes, open.scale, open.areaSize)) return null
    return Promise.resolve(this.#parts.attempt(() => this.#prepare(open)))
  }

  #addTool(host: ToolHost, target: () => PaintTarget | null, shape: PaintShape): void {
    const { wake } = this.#parts
    const tool = new PaintTool({
      target,
      waitsFor: () => this.#waitsFor(),
      onPaint: wake,
      show: (area, weights) => this.#show(area, weights),
      keep: (area, weights) => this.#keep(area, weights),
      onHit: (hit) => {
        this.#hit.value = hit
        this.#drawRing()
      },
    })
    this.#tools.push({ tool, host })
    this.#offer(host, tool, shape)
  }

  /** Lets a tool have the pointer while its shape is painted. */
  #offer(host: ToolHost, tool: StageTool, shape: PaintShape): void {
    effect(() => {
      this.#parts.viewer.value
      if (this.area.value === null || this.shape.value !== shape) host.leave(tool)
      else host.choose(tool)
    })
  }

  #keep(area: string, weights: GrayImage): void {
    this.#parts.session.edit(`Paint ${area}`, (old) => paintArea(old, area, weights))
  }

  #targetOnFace(): PaintTarget | null {
    const [viewer, area, face] = [this.#parts.viewer.peek(), this.#parts.areas.chosen.peek(), this.#face()]
    if (!viewer || !area || !face) return null
    const { skin, picker } = face
    const sight = this.isThrough.peek() ? undefined : picker.sightFrom(viewer.stage.camera.position)
    return { area, brush: this.brush.peek(), skin, picker, sight }
  }

  /** The texture shows what the camera does not see. */
  #targetOnTexture(): PaintTarget | null {
    const [area, face] = [this.#parts.areas.chosen.peek(), this.#face()]
    return area && face && { area, brush: this.brush.peek(), skin: face.skin, picker: face.texture }
  }

  /** As it is posed now; null until its skin is made. */
  #face(): PaintedFace | null {
    const open = this.#open()
    const made = open && preparedSkin(open.meshes, open.scale, open.areaSize)
    if (!made) return null
    const { skin, picker } = made
    return { skin, picker, texture: new TexturePicker(skin, picker, open.areaSize) }
  }

  #open(): OpenFace | null {
    const [viewer, document] = [this.#parts.viewer.peek(), this.#parts.session.document.peek()]
    if (!viewer || !document) return null
    const { skins, skin } = viewer.avatar
    const { scale, areaSize } = document
    return { meshes: skins[skin].meshes, scale, areaSize }
  }

  #show(area: string, weights: GrayImage): void {
    const isKept = this.#parts.areas.chosen.peek()?.weights === weights
    // Another object, since its data has changed in place.
    this.#stroke.value = isKept ? null : { ...weights }
    const wrinkles = this.#parts.viewer.peek()?.wrinkles
    if (wrinkles?.hasArea(area)) updateArea(wrinkles, area, weights)
  }

  #drawRing(): void {
    const [viewer, document] = [this.#parts.viewer.peek(), this.#parts.session.document.peek()]
    const hit = this.#hit.peek()
    if (!hit || !viewer || !document) {
      this.#ring.hide()
      return
    }
    const { point, normal } = hit
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

function isLarge(meshes: OpenFace['meshes']): boolean {
  return meshes.reduce((sum, { geometry }) => sum + geometry.attributes.position.count, 0) > MOST_PREPARED
}

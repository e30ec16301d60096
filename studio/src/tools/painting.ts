import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import type { GrayImage } from 'furrow'
import { updateArea } from 'furrow/three'
import { type Ray, Vector3 } from 'three'
import { paintedArea } from '../document/painted-area.ts'
import { BRUSH_DEFAULTS, type Brush, resized } from '../paint/brush.ts'
import { visibleRadius } from '../paint/dab-size.ts'
import { mirrorWeights } from '../paint/mirror-weights.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import type { SkinHit } from '../paint/picker.ts'
import { posedSkinOf } from '../paint/posed-skin.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'
import { shortcutOf } from '../shortcuts.ts'
import type { Viewer } from '../viewer/viewer.ts'
import type { AreaTarget } from './area-target.ts'
import { BrushRing } from './brush-ring.ts'
import type { FaceSkin, PaintedFace } from './face-skin.ts'
import { PaintTool } from './paint-tool.ts'
import { PolygonPainting } from './polygon-painting.ts'
import type { StageTool } from './stage-tool.ts'
import type { TextureCamera } from './texture-camera.ts'
import type { ToolHost } from './tool-host.ts'

export type PaintShape = 'brush' | 'polygon'

export interface PaintingParts {
  session: Session
  areas: AreaEditor
  viewer: ReadonlySignal<Viewer | null>
  face: FaceSkin
  host: ToolHost
  /** Element over which the outline of the brush is drawn. */
  stage: HTMLElement
  /** Requests the next frame. */
  wake(): void
  /** Called when the user has added skin to an area. */
  onPainted(area: string): void
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** Lets the user paint areas: the chosen one, the one under the pointer, or a new one. Stores the tools and their settings. */
export class Painting {
  readonly #parts: PaintingParts
  /** Brush tools for the face and the texture. `host` sends pointer events to the tool. */
  readonly #tools: { tool: PaintTool<AreaTarget>; host: ToolHost }[] = []
  readonly #ring: BrushRing
  readonly #hit = signal<SkinHit | null>(null)
  readonly #stroke = signal<GrayImage | null>(null)
  readonly #isUncovered = signal(false)
  /** Whether the current stroke adds its area. */
  #isAdding = false

  readonly isOn = signal(false)
  readonly brush = signal<Brush>(BRUSH_DEFAULTS)
  /** Whether the user paints with a brush or with polygons. */
  readonly shape = signal<PaintShape>('brush')
  readonly polygon: PolygonPainting
  /** Whether to also paint skin that is hidden from the camera. */
  readonly isHiddenPainted = signal(false)
  /** Name of the chosen area, or null while painting is off. */
  readonly area: ReadonlySignal<string | null> = computed(() =>
    this.isOn.value ? (this.#parts.areas.chosen.value?.name ?? null) : null,
  )

  /** Name of the area to highlight, or null. */
  readonly highlighted: ReadonlySignal<string | null> = computed(() =>
    this.#isUncovered.value ? null : this.area.value,
  )

  constructor(parts: PaintingParts) {
    this.#parts = parts
    const { session, host } = parts
    this.#ring = new BrushRing(parts.stage)
    this.#addTool(host, (ray) => this.#targetOnFace(ray), 'brush')
    this.polygon = new PolygonPainting({
      ...parts,
      brush: this.brush,
      preparation: () => this.#preparation(),
      keep: (target, weights) => this.#keep(target, weights),
    })
    const onFace = this.polygon.addView({
      element: parts.stage,
      camera: () => parts.viewer.peek()?.stage.camera ?? null,
      target: () => this.#targetOnFace(),
      positionOf: ({ triangle, weights }) =>
        this.#face()?.picker.positionOf(triangle, weights, new Vector3()) ?? null,
    })
    this.#bind(host, onFace, 'polygon')
    effect(() => {
      if (!this.isOn.value || this.shape.value !== 'polygon') this.polygon.clear()
    })
    effect(() => {
      if (this.isOn.value) void this.#preparation()
    })
    // Cancel the stroke whenever the document changes. Undo, for example, may have replaced the weights that the stroke changes.
    effect(() => {
      session.document.value
      if (this.#isAdding) return
      if (this.isOn.peek()) for (const { host } of this.#tools) host.cancel()
      this.#stroke.value = null
    })
    effect(() => {
      this.brush.value
      parts.wake()
    })
    addEventListener('keydown', (event) => this.#onKey(event))
  }

  /** Brush position on the skin, or null. */
  get hit(): ReadonlySignal<SkinHit | null> {
    return this.#hit
  }

  /** Weights of the area including the current stroke. Each change creates a new object. Null between strokes. */
  get stroke(): ReadonlySignal<GrayImage | null> {
    return this.#stroke
  }

  /** Skin of the open face, or null until it is ready. */
  get skin(): PaintSkin | null {
    return this.#face()?.skin ?? null
  }

  /** Version number, incremented when a skin is ready. */
  get skinVersion(): ReadonlySignal<number> {
    return this.#parts.face.version
  }

  /**
   * Adds tools for painting on the texture.
   *
   * @param host tool host whose rays come from the texture camera.
   * @param element element that shows the texture.
   */
  addTexture(host: ToolHost, element: HTMLElement, { camera }: TextureCamera): void {
    const target = (ray?: Ray) => this.#targetOnTexture(ray)
    this.#addTool(host, target, 'brush')
    const positionOf = ({ uv: [u, v] }: SkinHit) => new Vector3(u, -v, 0)
    this.#bind(host, this.polygon.addView({ element, camera: () => camera, target, positionOf }), 'polygon')
  }

  /** Mirrors the weights of an area to the other side of the open face. */
  mirrored(weights: GrayImage): GrayImage {
    const { open } = this.#parts.face
    return open ? mirrorWeights(weights, posedSkinOf(open.meshes, open.scale).skin) : weights
  }

  /** Ends the highlight of the area until the next stroke, so that users see its wrinkles. */
  uncover(): void {
    this.#isUncovered.value = true
  }

  /** Shows the current stroke and updates the outlines. Call before each frame. */
  advance(): void {
    for (const { tool } of this.#tools) tool.showStroke()
    this.#drawRing()
    this.polygon.advance()
  }

  #addTool(host: ToolHost, target: (ray: Ray) => AreaTarget | null, shape: PaintShape): void {
    const { wake, session } = this.#parts
    const tool = new PaintTool<AreaTarget>({
      target,
      preparation: () => this.#preparation(),
      onPaint: wake,
      show: (stroke, weights) => {
        this.#isUncovered.value = false
        if (!this.#isKnown(stroke)) this.#add(stroke, weights)
        this.#show(stroke.name, weights)
      },
      keep: (stroke, weights) => this.#keep(stroke, weights),
      discard: (stroke) => {
        session.settle()
        if (stroke.isNew && this.#isKnown(stroke)) session.undo()
        else this.#show(stroke.name, stroke.image)
        wake()
      },
      onHit: (hit) => {
        this.#hit.value = hit
        this.#drawRing()
      },
    })
    this.#tools.push({ tool, host })
    this.#bind(host, tool, shape)
  }

  /** Activates a tool while painting is on and `shape` is chosen. */
  #bind(host: ToolHost, tool: StageTool, shape: PaintShape): void {
    effect(() => {
      if (!this.isOn.value || this.shape.value !== shape) host.leave(tool)
      else host.choose(tool)
    })
  }

  #isKnown({ name }: AreaTarget): boolean {
    return this.#parts.session.document.peek()?.areas.some((area) => area.name === name) ?? false
  }

  /** Adds the area of a stroke that has begun on bare skin, so that the face shows it. */
  #add({ area }: AreaTarget, weights: GrayImage): void {
    this.#isAdding = true
    try {
      // Copy the weights, because the stroke changes them in place.
      this.#parts.areas.paint(area, { ...weights, data: weights.data.slice() })
    } finally {
      this.#isAdding = false
    }
  }

  #keep({ area }: AreaTarget, weights: GrayImage): void {
    const { areas, onPainted } = this.#parts
    areas.paint(area, weights)
    areas.settle()
    const { mode } = this.brush.peek()
    if (mode === 'add' || mode === 'fill') onPainted(area.name)
  }

  #targetOnFace(ray?: Ray): AreaTarget | null {
    const [viewer, face] = [this.#parts.viewer.peek(), this.#face()]
    if (!viewer || !face) return null
    const { skin, picker } = face
    const sight = this.isHiddenPainted.peek() ? undefined : picker.sightFrom(viewer.stage.camera.position)
    return this.#target({ skin, picker, sight }, ray)
  }

  /** Returns a target without a visibility test, because painting on the texture includes hidden skin. */
  #targetOnTexture(ray?: Ray): AreaTarget | null {
    const face = this.#face()
    return face && this.#target({ skin: face.skin, picker: face.texture }, ray)
  }

  #target(skin: Pick<AreaTarget, 'skin' | 'picker' | 'sight'>, ray?: Ray): AreaTarget | null {
    const document = this.#parts.session.document.peek()
    if (!document) return null
    const chosen = this.#parts.areas.chosen.peek()
    const area = paintedArea(document, chosen, chosen || !ray ? undefined : skin.picker.pick(ray)?.uv)
    const isNew = !document.areas.includes(area)
    return { ...skin, name: area.name, image: area.weights, brush: this.brush.peek(), area, isNew }
  }

  /** Returns the open face, or null until its skin is ready. */
  #face(): PaintedFace | null {
    const { face } = this.#parts
    return face.open && face.at(face.open.areaSize)
  }

  #preparation(): Promise<unknown> | null {
    const { face } = this.#parts
    return face.open && face.preparation(face.open.areaSize)
  }

  #show(area: string, weights: GrayImage): void {
    const isKept = this.#parts.areas.chosen.peek()?.weights === weights
    // Copy the object, because its data changes in place and signals compare identities.
    this.#stroke.value = isKept ? null : { ...weights }
    const wrinkles = this.#parts.viewer.peek()?.wrinkles
    if (wrinkles?.hasArea(area)) updateArea(wrinkles, area, weights)
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

  /** Returns the radius of the brush outline at a point of the skin, millimetres. It shows the true size of a dab, also where texels are large. */
  ringRadius({ triangle }: Pick<SkinHit, 'triangle'>): number {
    const [brush, size] = [this.brush.peek(), this.#parts.session.document.peek()?.areaSize]
    return this.skin && size ? visibleRadius(this.skin.mapOf(size), brush, triangle) : brush.radius
  }

  #onKey(event: KeyboardEvent): void {
    const name = shortcutOf('painting', event)
    if (this.area.peek() === null || !name) return
    const { mode, radius } = this.brush.peek()
    const change: Partial<Brush> =
      name === 'swap' ? { mode: mode === 'add' ? 'remove' : 'add' } : { radius: resized(radius, name) }
    this.brush.value = { ...this.brush.peek(), ...change }
  }
}

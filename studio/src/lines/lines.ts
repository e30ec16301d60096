import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError, type GrayImage } from 'furrow'
import type { SkinHit } from '../paint/picker.ts'
import type { Session } from '../session/session.ts'
import { shortcutOf } from '../shortcuts.ts'
import { rayAt } from '../tools/ray-at.ts'
import type { ToolHost } from '../tools/tool-host.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { bindLineTool, type LineView } from './bind-line-tool.ts'
import { LineEditor } from './line-editor.ts'
import { LineOverlay } from './line-overlay.ts'
import { pictureOf } from './line-picture.ts'
import { nextReach } from './line-points.ts'
import { type LineSkin, readLineSkin } from './line-skin.ts'
import { LineTool } from './line-tool.ts'
import { LineProjection, type ProjectedLine } from './project-lines.ts'
import { placeOfArea, placeOfLines, type SkinPlace } from './skin-place.ts'
import { TextureLineView } from './texture-line-view.ts'

/** Time without motion of the pointer after which the lines fade, milliseconds. */
const IDLE = 4000

export interface LinesParts {
  /** Element that shows the face. */
  stage: HTMLElement
  session: Session
  viewer: ReadonlySignal<Viewer | null>
  tools: ToolHost
  /** Whether the face moves. Lines that the pointer could choose are then not updated. */
  isMoving(): boolean
  /** Called when the pointer is on the skin beside all lines, while it selects; null: elsewhere. */
  onSkin(hit: SkinHit | null): void
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** Shows the document's wrinkle lines as curves on the face, and lets the pointer edit them. */
export class Lines {
  readonly editor: LineEditor
  readonly #parts: LinesParts
  readonly #overlay: LineOverlay
  readonly #tool: LineTool
  readonly #skin = signal<LineSkin | null>(null)
  /** Pending call of `readLineSkin`, or null. */
  #reading: Promise<void> | null = null
  /** Arguments of the last call of `readLineSkin`. */
  #source: readonly unknown[] = []
  readonly #projection = new LineProjection()
  #lines: ProjectedLine[] = []
  /** Whether the pointer has been on the stage since the face was opened, so that lines can be selected. */
  readonly #isPointed = signal(false)
  /** Whether lines are drawn over the face. */
  readonly isShown = signal(true)
  #request = 0
  #idle = 0

  constructor(parts: LinesParts) {
    const { session, stage, tools, attempt } = parts
    this.#parts = parts
    this.#overlay = new LineOverlay(stage)
    this.editor = new LineEditor(session, () => this.#skin.value)
    const [skin, lines] = [this.#skin, () => this.#lines]
    this.#tool = new LineTool(this.editor, {
      get picker() {
        return skin.peek()?.picker ?? null
      },
      get lines() {
        return lines()
      },
      preparation: () => this.#reading,
      onChange: () => this.#redraw(),
      onSkin: (hit) => parts.onSkin(hit),
    })
    effect(() => this.#readSkin())
    stage.addEventListener('pointermove', ({ buttons }) => this.#point(buttons !== 0))
    // Tools that capture the pointer stop this event, so the gesture moves the camera.
    stage.addEventListener('pointerdown', () => this.#point(true))
    stage.addEventListener('pointerup', () => this.#point(false))
    effect(() => {
      this.isShown.value
      const { mode, allChosen, point, points } = this.editor
      if (mode.value === 'off') this.#overlay.hide()
      allChosen.value
      point.value
      points.reach.value
      this.#skin.value
      session.document.value
      this.#redraw()
    })
    bindLineTool(this.#tool, this.editor, { element: stage, host: tools, attempt })
    addEventListener('keydown', (event) => {
      const name = this.editor.mode.peek() === 'edit' ? shortcutOf('bending', event) : undefined
      if (name) this.editor.points.reach.value = nextReach(this.editor.points.reach.peek(), name)
    })
  }

  /**
   * Lets the pointer edit lines in the view of the texture too.
   *
   * @param wake requests the next frame of the view.
   */
  addTexture(view: Omit<LineView, 'attempt'>, wake: () => void): TextureLineView {
    return new TextureLineView(
      {
        editor: this.editor,
        skin: () => this.#skin.value,
        preparation: () => this.#reading,
        wake,
      },
      { ...view, attempt: this.#parts.attempt },
    )
  }

  /**
   * Moves the chosen point of a line over the skin, by a distance on the screen. Ignores moves that leave the skin.
   *
   * @param right distance to the right, CSS pixels.
   * @param down distance downwards, CSS pixels.
   * @throws FurrowError if the point is hidden from the camera.
   */
  movePoint(right: number, down: number): void {
    const camera = this.#parts.viewer.peek()?.stage.camera
    const [stroke, skin] = [this.editor.chosen.peek(), this.#skin.peek()]
    if (!camera || !stroke || !skin) return
    const { size } = this.#overlay
    // Project the line again, because several keys can be pressed between two frames.
    const [line] = this.#projection.project([stroke], skin, camera, size)
    const i = this.editor.handles.peek()[this.editor.point.peek()]?.place
    if (!line || i === undefined) return
    if (!line.isSeen[i]) throw hiddenPointError()
    const hit = skin.picker.pick(rayAt(camera, [line.x[i] + right, line.y[i] + down], size))
    if (hit) this.editor.points.move(hit.uv)
  }

  /** Returns a promise that settles when the skin is ready, or null if nothing is being prepared. */
  preparation(): Promise<unknown> | null {
    return this.#reading?.catch(() => {}) ?? null
  }

  /** Returns the skin at a position on the stage, CSS pixels, or undefined. */
  pickAt(x: number, y: number): SkinHit | undefined {
    const camera = this.#parts.viewer.peek()?.stage.camera
    return camera && this.#skin.peek()?.picker.pick(rayAt(camera, [x, y], this.#overlay.size))
  }

  /**
   * Returns the middle and the radius of the chosen lines, or of an area, on the face in world space. Returns null if there is neither, or
   * before the skin is ready.
   */
  placeOf(weights: GrayImage | null): SkinPlace | null {
    const [skin, lines] = [this.#skin.peek(), this.editor.allChosen.peek()]
    if (!skin) return null
    skin.follow()
    if (lines.length > 0) return placeOfLines(skin, lines)
    return weights && placeOfArea(skin, weights)
  }

  draw(): void {
    const { session, viewer } = this.#parts
    const skin = this.#skin.peek()
    const document = session.document.peek()
    const mode = this.editor.mode.peek()
    const isSelecting = mode === 'select'
    const isHidden = !this.isShown.peek() || (isSelecting && this.#parts.isMoving())
    if (mode === 'off' || isHidden || !skin || !document || !viewer.peek()) {
      this.#overlay.hide()
      return
    }
    const { camera } = viewer.peek()!.stage
    this.#lines = this.#projection.project(document.strokes, skin, camera, this.#overlay.size)
    const picture = pictureOf(this.editor, this.#tool, this.#lines)
    // While the pointer selects, all other lines would only hide the face.
    const isSeen = ({ stroke }: ProjectedLine) =>
      picture.chosen.includes(stroke) || stroke === picture.hovered
    this.#overlay.draw(
      isSelecting ? { ...picture, lines: picture.lines.filter(isSeen), handles: [], forks: [] } : picture,
    )
  }

  /** Fades the lines while the pointer moves the camera, and when it rests. */
  #point(isDragging: boolean): void {
    this.#isPointed.value = true
    this.#overlay.isFaded = isDragging
    clearTimeout(this.#idle)
    this.#idle = window.setTimeout(() => {
      this.#overlay.isFaded = true
    }, IDLE)
  }

  /** Draws the lines in the next frame, without drawing the face. */
  #redraw(): void {
    this.#request ||= requestAnimationFrame(() => {
      this.#request = 0
      this.draw()
    })
  }

  /** Returns the skin of the current face, and prepares it if needed. Rejects with a FurrowError if it cannot be painted. */
  async readySkin(): Promise<LineSkin | null> {
    await this.#read()
    return this.#skin.peek()
  }

  /** Reads the skin of the current face when line editing begins, or when the skin, scale or area size changes later. */
  #readSkin(): void {
    const { session, viewer, attempt } = this.#parts
    session.document.value
    viewer.value
    const mode = this.editor.mode.value
    if (mode === 'off' || (mode === 'select' && !this.#isPointed.value)) return
    const before = this.#reading
    const reading = this.#read()
    if (reading && reading !== before) void attempt(() => reading)
  }

  /** Reads the skin of the current face, unless it is known. Returns a promise that resolves when it is known, or null. */
  #read(): Promise<void> | null {
    const [document, avatar] = [this.#parts.session.document.peek(), this.#parts.viewer.peek()?.avatar]
    const skin = avatar?.skins[avatar.skin]
    const source = [skin, document?.scale, document?.areaSize]
    if (source.every((value, i) => value === this.#source[i])) return this.#reading
    this.#source = source
    this.#skin.value = null
    this.#reading = null
    if (!skin || !document) return null
    const { scale, areaSize } = document
    const reading = readLineSkin(skin.meshes, scale, areaSize)
      .then((own) => {
        if (reading === this.#reading) this.#skin.value = own
      })
      .finally(() => {
        if (reading === this.#reading) this.#reading = null
      })
    this.#reading = reading
    return reading
  }
}

function hiddenPointError(): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'the point of the line is hidden',
    remedy: 'turn the face until the point is visible',
  })
}

import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError } from 'furrow'
import type { Session } from '../session/session.ts'
import { rayAt } from '../tools/ray-at.ts'
import type { ToolHost } from '../tools/tool-host.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { bindLineTool, type LineView } from './bind-line-tool.ts'
import { LineEditor } from './line-editor.ts'
import { LineOverlay } from './line-overlay.ts'
import { pictureOf } from './line-picture.ts'
import { type LineSkin, readLineSkin } from './line-skin.ts'
import { LineTool } from './line-tool.ts'
import { LineProjection, type ProjectedLine } from './project-lines.ts'
import { TextureLineView } from './texture-line-view.ts'

export interface LinesParts {
  /** Element that shows the face. */
  stage: HTMLElement
  session: Session
  viewer: ReadonlySignal<Viewer | null>
  tools: ToolHost
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
  #request = 0

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
    })
    effect(() => this.#readSkin())
    effect(() => {
      const { mode, chosen, point } = this.editor
      if (mode.value === 'off') this.#overlay.hide()
      chosen.value
      point.value
      this.#skin.value
      session.document.value
      this.#redraw()
    })
    bindLineTool(this.#tool, this.editor, { element: stage, host: tools, attempt })
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
    if (hit) this.editor.movePoint(hit.uv)
  }

  draw(): void {
    const { session, viewer } = this.#parts
    const skin = this.#skin.peek()
    const document = session.document.peek()
    const mode = this.editor.mode.peek()
    if (mode === 'off' || !skin || !document || !viewer.peek()) {
      this.#overlay.hide()
      return
    }
    const { camera } = viewer.peek()!.stage
    this.#lines = this.#projection.project(document.strokes, skin, camera, this.#overlay.size)
    this.#overlay.draw(pictureOf(this.editor, this.#tool, this.#lines))
  }

  /** Draws the lines in the next frame, without drawing the face. */
  #redraw(): void {
    this.#request ||= requestAnimationFrame(() => {
      this.#request = 0
      this.draw()
    })
  }

  /** Reads the skin of the current face when line editing begins, or when the skin, scale or area size changes later. */
  #readSkin(): void {
    const { session, viewer, attempt } = this.#parts
    const document = session.document.value
    const avatar = viewer.value?.avatar
    if (this.editor.mode.value === 'off') return
    const skin = avatar?.skins[avatar.skin]
    const source = [skin, document?.scale, document?.areaSize]
    if (source.every((value, i) => value === this.#source[i])) return
    this.#source = source
    this.#skin.value = null
    this.#reading = null
    if (!skin || !document) return
    const { scale, areaSize } = document
    const reading = readLineSkin(skin.meshes, scale, areaSize).then((own) => {
      if (reading === this.#reading) this.#skin.value = own
    })
    this.#reading = reading
    void attempt(() =>
      reading.finally(() => {
        if (reading === this.#reading) this.#reading = null
      }),
    )
  }
}

function hiddenPointError(): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'the point of the line is hidden',
    remedy: 'turn the face until the point is visible',
  })
}

import { effect } from '@preact/signals'
import type { LayerStroke } from '../document/document.ts'
import { TEXTURE_JUMP, type TextureFrame } from '../tools/texture-camera.ts'
import { bindLineTool, type LineView } from './bind-line-tool.ts'
import type { LineEditor } from './line-editor.ts'
import { drawChosen } from './line-overlay.ts'
import { pictureOf } from './line-picture.ts'
import type { LineSkin } from './line-skin.ts'
import { LineTool } from './line-tool.ts'
import type { ProjectedLine } from './project-lines.ts'

export interface TextureLineParts {
  editor: LineEditor
  /** Returns the skin of the current face, or null until it is ready. */
  skin(): LineSkin | null
  /** Returns a promise that resolves when the skin is ready, or null if it is not being prepared. */
  preparation(): Promise<unknown> | null
  /** Requests the next frame. */
  wake(): void
}

/** Lets the pointer edit wrinkle lines in the view of the texture, as on the face. */
export class TextureLineView {
  readonly #parts: TextureLineParts
  readonly #tool: LineTool
  #lines: readonly ProjectedLine[] = []

  constructor(parts: TextureLineParts, view: LineView) {
    const { editor, skin, preparation, wake } = parts
    this.#parts = parts
    const lines = () => this.#lines
    this.#tool = new LineTool(editor, {
      get picker() {
        return skin()?.texturePicker ?? null
      },
      get lines() {
        return lines()
      },
      preparation,
      onChange: wake,
    })
    bindLineTool(this.#tool, editor, view)
    effect(() => {
      editor.mode.value
      editor.handles.value
      editor.point.value
      editor.points.reach.value
      editor.allChosen.value
      wake()
    })
  }

  /** Draws the chosen line and all forks, while lines are edited. @param context canvas context whose units are CSS pixels. */
  draw(
    context: CanvasRenderingContext2D,
    size: readonly [width: number, height: number],
    frame: TextureFrame,
  ): void {
    const { editor, skin } = this.#parts
    const own = skin()
    const document = editor.session.document.peek()
    this.#lines = []
    if (editor.mode.peek() === 'off' || !own || !document) return
    this.#lines = document.strokes.flatMap((stroke) => inTexture(stroke, own, size, frame) ?? [])
    drawChosen(context, pictureOf(editor, this.#tool, this.#lines))
  }
}

/** Converts a line to a polyline in the view of the texture. The line is interrupted at UV seams. Returns null if it is not on the skin. */
function inTexture(
  stroke: LayerStroke,
  skin: LineSkin,
  [width, height]: readonly [number, number],
  { centre, scale }: TextureFrame,
): ProjectedLine | null {
  const line = skin.lineOf(stroke)
  const uvs = skin.uvsOf(stroke)
  if (!line || !uvs) return null
  const count = uvs.length / 2
  const isFar = (i: number) =>
    Math.hypot(uvs[2 * i + 2] - uvs[2 * i], uvs[2 * i + 3] - uvs[2 * i + 1]) >= TEXTURE_JUMP
  return {
    stroke,
    x: Float32Array.from({ length: count }, (_, i) => (uvs[2 * i] - centre[0]) * scale + width / 2),
    y: Float32Array.from({ length: count }, (_, i) => (uvs[2 * i + 1] - centre[1]) * scale + height / 2),
    isSeen: Array.from({ length: count }, (_, i) => i + 1 === count || !isFar(i)),
    along: line.along,
  }
}

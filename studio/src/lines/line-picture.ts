import type { LayerStroke } from '../document/document.ts'
import type { Handle } from './handles.ts'
import type { LineEditor } from './line-editor.ts'
import type { LineTool } from './line-tool.ts'
import { type ProjectedFork, type ProjectedLine, projectForks } from './project-lines.ts'

/** Lines and handles to draw. `path` is the path of the pointer while it draws a new line. */
export interface LinePicture {
  readonly lines: readonly ProjectedLine[]
  readonly chosen: LayerStroke | null
  /** Points and forks of the chosen line. */
  readonly handles: readonly Handle[]
  /** Index of the chosen handle, or -1. */
  readonly point: number
  /** Forks of all lines. */
  readonly forks: readonly ProjectedFork[]
  readonly hovered: LayerStroke | null
  readonly path: readonly { x: number; y: number }[]
}

/** Returns the current picture of all lines. While the user moves a point, omits lines that stay, which would cover the wrinkles. */
export function pictureOf(
  editor: LineEditor,
  { hovered, path, isBending }: LineTool,
  all: readonly ProjectedLine[],
): LinePicture {
  const chosen = editor.chosen.peek()
  const lines = isBending ? all.filter(({ stroke }) => stroke === chosen || editor.isMoving(stroke)) : all
  const strokes = editor.session.document.peek()?.strokes ?? []
  return {
    lines,
    chosen,
    handles: editor.handles.peek(),
    point: editor.point.peek(),
    forks: projectForks(editor.forks.peek(), strokes, lines),
    hovered,
    path,
  }
}

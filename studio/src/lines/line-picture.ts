import type { LayerStroke } from '../document/document.ts'
import type { Handle } from './handles.ts'
import type { LineEditor } from './line-editor.ts'
import type { LineTool } from './line-tool.ts'
import { type ProjectedFork, type ProjectedLine, projectForks } from './project-lines.ts'

/** Lines and handles to draw. `path` is the path of the pointer while it draws a new line. */
export interface LinePicture {
  readonly lines: readonly ProjectedLine[]
  /** Chosen lines, first the main one. */
  readonly chosen: readonly LayerStroke[]
  /** Points and forks of the main chosen line. */
  readonly handles: readonly Handle[]
  /** Index of the chosen handle, or -1. */
  readonly point: number
  /** Fraction of the motion that each handle would make if the chosen handle, or the one under the pointer, moved. */
  readonly weights: readonly number[]
  /** Forks of all lines. */
  readonly forks: readonly ProjectedFork[]
  readonly hovered: LayerStroke | null
  readonly path: readonly { x: number; y: number }[]
}

/** Returns the current picture of all lines. While the user moves a point, omits lines that stay, which would cover the wrinkles. */
export function pictureOf(
  editor: LineEditor,
  { hovered, hoveredPoint, path, isBending }: LineTool,
  all: readonly ProjectedLine[],
): LinePicture {
  const chosen = editor.allChosen.peek()
  const isShown = ({ stroke }: ProjectedLine) => chosen.includes(stroke) || editor.isMoving(stroke)
  const lines = isBending ? all.filter(isShown) : all
  const strokes = editor.session.document.peek()?.strokes ?? []
  return {
    lines,
    chosen,
    handles: editor.handles.peek(),
    point: editor.point.peek(),
    weights: editor.points.grabWeights(hoveredPoint < 0 || isBending ? editor.point.peek() : hoveredPoint),
    forks: projectForks(editor.forks.peek(), strokes, lines),
    hovered,
    path,
  }
}

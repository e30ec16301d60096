/** Sheet of 100 x 100 mm that fills a stage of SIDE x SIDE CSS pixels, for tests that edit lines with a pointer. */

import { skinCanvas } from 'furrow/author'
import { StrokeLines, uvOf } from 'furrow/internal'
import { Ray, Vector3 } from 'three'
import type { LayerStroke } from '../../../../studio/src/document/document.ts'
import { LineEditor } from '../../../../studio/src/lines/line-editor.ts'
import { LineTool } from '../../../../studio/src/lines/line-tool.ts'
import type { ProjectedLine } from '../../../../studio/src/lines/project-lines.ts'
import type { SkinHit } from '../../../../studio/src/paint/picker.ts'
import { readSkin } from '../../../../studio/src/paint/read-skin.ts'
import type { Session } from '../../../../studio/src/session/session.ts'
import type { StagePointer } from '../../../../studio/src/tools/stage-tool.ts'
import { plainSheet } from '../paint/skins.ts'

/** Width and height of the areas, texels. */
export const SIZE = 32
export const SIDE = 1000

export const canvas = skinCanvas(readSkin([plainSheet()]).skin, SIZE)
export const lines = new StrokeLines(canvas)

/** Picks a point of the sheet. */
export function pick({ origin: { x, y } }: Ray): SkinHit | undefined {
  return { position: [x / 10, y / 10, 0], uv: [x / SIDE, y / SIDE] } as unknown as SkinHit
}

/** Returns a line as the stage shows it. */
export function seen(stroke: LayerStroke): ProjectedLine {
  const line = lines.lineOf(stroke)!
  const uvs = line.triangles.map((_, i) => uvOf(line, i, canvas))
  return {
    stroke,
    x: Float32Array.from(uvs, ([u]) => SIDE * u),
    y: Float32Array.from(uvs, ([, v]) => SIDE * v),
    isSeen: uvs.map(() => true),
    along: line.lengths.map((length) => length / line.lengths.at(-1)!),
  }
}

/** Returns a pointer at a point of the stage. */
export function at(x: number, y: number, shift = false): StagePointer {
  const ray = new Ray(new Vector3(x, y, 1), new Vector3(0, 0, -1))
  return { ray, x, y, shift, alt: false, pressure: 1 }
}

/** Returns an editor of the lines of `session`, and a pointer tool for them. */
export function editorOn(session: Session, picker = { pick }): { editor: LineEditor; tool: LineTool } {
  const editor = new LineEditor(session, () => ({ canvas, lines, middle: undefined }))
  editor.mode.value = 'edit'
  const tool = new LineTool(editor, {
    picker,
    get lines() {
      return session.document.value!.strokes.map(seen)
    },
    preparation: () => null,
    onChange() {},
  })
  return { editor, tool }
}

import { skinCanvas } from 'furrow/author'
import { Ray, Vector3 } from 'three'
import { beforeEach, expect, test } from 'vitest'
import { LineEditor } from '../../../../studio/src/lines/line-editor.ts'
import { LineTool } from '../../../../studio/src/lines/line-tool.ts'
import type { ProjectedLine } from '../../../../studio/src/lines/project-lines.ts'
import type { SkinHit } from '../../../../studio/src/paint/picker.ts'
import { readSkin } from '../../../../studio/src/paint/read-skin.ts'
import { Session } from '../../../../studio/src/session/session.ts'
import type { StagePointer } from '../../../../studio/src/tools/stage-tool.ts'
import { plainSheet } from '../paint/skins.ts'
import { sampleDocument } from '../sample-document.ts'

const SIZE = 32
/** CSS pixels of the sheet's side on the stage: 10 per millimetre. */
const SIDE = 1000

const canvas = skinCanvas(readSkin([plainSheet()]).skin, SIZE)
let session: Session
let editor: LineEditor
let tool: LineTool

beforeEach(() => {
  session = new Session()
  const sample = sampleDocument()
  const weights = { width: SIZE, height: SIZE, data: new Uint8Array(SIZE * SIZE) }
  session.open({ ...sample, areaSize: SIZE, areas: sample.areas.map((area) => ({ ...area, weights })) })
  editor = new LineEditor(session, () => ({ canvas, middle: undefined }))
  editor.mode.value = 'edit'
  tool = new LineTool(editor, {
    picker: { pick },
    get lines() {
      return session.document.value!.strokes.map(seen)
    },
    preparation: () => null,
    onChange() {},
  })
})

/** The sheet's texture seen from above; the right tenth is not skin. */
function pick({ origin: { x, y } }: Ray): SkinHit | undefined {
  if (x > 0.9 * SIDE) return undefined
  const position = [x / 10, y / 10, 0] as const
  return { position, uv: [x / SIDE, y / SIDE] } as unknown as SkinHit
}

function seen(stroke: ProjectedLine['stroke']): ProjectedLine {
  const { points } = stroke
  return {
    stroke,
    x: Float32Array.from(points, ([u]) => SIDE * u),
    y: Float32Array.from(points, ([, v]) => SIDE * v),
    isSeen: points.map(() => true),
    along: Float64Array.from(points, (_, i) => i / (points.length - 1)),
    knots: [...points.keys()],
  }
}

function at(x: number, y: number, shift = false): StagePointer {
  const ray = new Ray(new Vector3(x, y, 1), new Vector3(0, 0, -1))
  return { ray, x, y, shift, alt: false, pressure: 1 }
}

const strokes = () => session.document.value!.strokes

test('a pointer off all lines moves the camera', () => {
  expect(tool.begin(at(500, 300))).toBe(false)
  expect(editor.chosen.value).toBeNull()
})

test('a click selects the line under it and changes nothing', () => {
  const { value: document } = session.document
  expect(tool.begin(at(500, 204))).toBe(true)
  tool.end()
  expect(editor.chosen.value).toBe(strokes()[0])
  expect(session.document.value).toBe(document)
})

test("a point of the selected line follows the pointer over the skin in one step, and stops at the skin's edge", () => {
  editor.choose(strokes()[0])
  expect(tool.begin(at(104, 203))).toBe(true)
  tool.move([at(120, 250), at(130, 260)])
  tool.move([at(150, 300)])
  tool.move([at(950, 300)])
  tool.end()
  expect(strokes()[0].points[0]).toEqual([0.15, 0.3])
  session.undo()
  expect(strokes()[0].points[0]).toEqual([0.1, 0.2])
  expect(session.undoLabel.value).toBeUndefined()
})

test('Escape restores the point', () => {
  editor.choose(strokes()[0])
  tool.begin(at(100, 200))
  tool.move([at(150, 300)])
  tool.cancel()
  expect(strokes()[0].points[0]).toEqual([0.1, 0.2])
})

test('a click with Shift on the selected line adds a point, and the same step moves it', () => {
  editor.choose(strokes()[0])
  tool.begin(at(500, 202, true))
  tool.move([at(500, 260)])
  tool.end()
  expect(strokes()[0].points.length).toBe(3)
  expect(strokes()[0].points[1]).toEqual([0.5, 0.26])
  session.undo()
  expect(strokes()[0].points.length).toBe(2)
})

test('a stroke on free skin becomes a line of few points; off the skin it moves the camera', () => {
  editor.mode.value = 'draw'
  expect(tool.begin(at(950, 700))).toBe(false)
  expect(tool.begin(at(200, 700))).toBe(true)
  tool.move(Array.from({ length: 100 }, (_, i) => at(200 + 4 * i, 700 + 2 * i)))
  tool.end()
  expect(strokes().length).toBe(4)
  expect(strokes()[3]).toMatchObject({
    curve: 'spline',
    points: [
      [0.2, 0.7],
      [0.596, 0.898],
    ],
  })
  session.undo()
  expect(strokes().length).toBe(3)
})

test('Escape or a plain click draws nothing', () => {
  editor.mode.value = 'draw'
  tool.begin(at(200, 700))
  tool.end()
  tool.begin(at(200, 700))
  tool.move([at(500, 700)])
  tool.cancel()
  expect(strokes().length).toBe(3)
})

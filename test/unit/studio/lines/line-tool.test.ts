import type { Ray } from 'three'
import { beforeEach, expect, test } from 'vitest'
import type { LineEditor } from '../../../../studio/src/lines/line-editor.ts'
import type { LineTool } from '../../../../studio/src/lines/line-tool.ts'
import { Session } from '../../../../studio/src/session/session.ts'
import { sampleDocument } from '../sample-document.ts'
import { at, editorOn, pick, SIDE, SIZE } from './sheet.ts'

let session: Session
let editor: LineEditor
let tool: LineTool

beforeEach(() => {
  session = new Session()
  const sample = sampleDocument()
  const weights = { width: SIZE, height: SIZE, data: new Uint8Array(SIZE * SIZE) }
  session.open({ ...sample, areaSize: SIZE, areas: sample.areas.map((area) => ({ ...area, weights })) })
  ;({ editor, tool } = editorOn(session, { pick: pickSkin }))
})

/** Picks a point of the sheet. Its right tenth is not skin. */
const pickSkin = (ray: Ray) => (ray.origin.x > 0.9 * SIDE ? undefined : pick(ray))

const strokes = () => session.document.value!.strokes

test('a pointer that is on no line moves the camera', () => {
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

test('a point of the selected line follows the pointer in one step, and stops at the edge of the skin', () => {
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

test('Escape returns the dragged point to its place', () => {
  editor.choose(strokes()[0])
  tool.begin(at(100, 200))
  tool.move([at(150, 300)])
  tool.cancel()
  expect(strokes()[0].points[0]).toEqual([0.1, 0.2])
})

test('a click with Shift on the selected line adds a point, which can be dragged in the same step', () => {
  editor.choose(strokes()[0])
  tool.begin(at(500, 202, true))
  tool.move([at(500, 260)])
  tool.end()
  expect(strokes()[0].points.length).toBe(3)
  expect(strokes()[0].points[1]).toEqual([0.5, 0.26])
  session.undo()
  expect(strokes()[0].points.length).toBe(2)
})

test('a stroke on free skin becomes a line of few points, and one off the skin moves the camera', () => {
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

test('a stroke ended by Escape, or a click without a stroke, draws nothing', () => {
  editor.mode.value = 'draw'
  tool.begin(at(200, 700))
  tool.end()
  tool.begin(at(200, 700))
  tool.move([at(500, 700)])
  tool.cancel()
  expect(strokes().length).toBe(3)
})

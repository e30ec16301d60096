import { skinCanvas, type Uv } from 'furrow/author'
import { StrokeLines } from 'furrow/internal'
import { beforeEach, expect, test } from 'vitest'
import type { LayerStroke } from '../../../../studio/src/document/document.ts'
import { LineEditor } from '../../../../studio/src/lines/line-editor.ts'
import { readSkin } from '../../../../studio/src/paint/read-skin.ts'
import { Session } from '../../../../studio/src/session/session.ts'
import { plainSheet } from '../paint/skins.ts'
import { frozen, sampleDocument, strokeOf } from '../sample-document.ts'

const canvas = skinCanvas(readSkin([plainSheet()]).skin, 32)
const lines = new StrokeLines(canvas)

const strokeAt = (group: string, ...points: Uv[]): LayerStroke => ({ ...strokeOf('up', group), points })

const LEFT = strokeAt('browLeft', [0.1, 0.3], [0.4, 0.3])
/** Counterpart of `LEFT`, 3 mm too low. */
const RIGHT = strokeAt('browRight', [0.9, 0.33], [0.6, 0.33])
const OTHER = strokeAt('browRight', [0.9, 0.6], [0.6, 0.6])
const ACROSS = strokeAt('brow', [0.1, 0.8], [0.9, 0.8])
const ALL = [LEFT, RIGHT, OTHER, ACROSS]

/** Plane through the middle of the sheet. */
const middle = (() => {
  const points = lines.lineOf(ACROSS)!.points
  const x = (points[0] + points[points.length - 3]) / 2 / canvas.scale
  return { origin: [x, 0, 0], normal: [1, 0, 0] } as const
})()

let session: Session
let editor: LineEditor
const strokes = () => session.document.value!.strokes

beforeEach(() => {
  session = new Session()
  session.open(frozen({ ...sampleDocument(), areaSize: 32, areas: [], drivers: [], strokes: ALL }))
  editor = new LineEditor(session, () => ({ canvas, lines, middle }))
  editor.mode.value = 'edit'
  editor.mirrored.value = true
  editor.choose(strokes()[0])
})

test('a new depth applies to the counterpart too, which keeps its place', () => {
  editor.fields.setShape({ depth: 1 })
  expect(strokes().map(({ depth }) => depth)).toEqual([1, 1, 0.5, 0.5])
  expect(strokes()[1].points).toEqual(RIGHT.points)
  session.undo()
  expect(strokes()[1]).toEqual(RIGHT)
})

test('a moved point moves the mirror image of the point', () => {
  editor.point.value = 0
  editor.points.move([0.15, 0.4])
  editor.settle()
  const [u, v] = strokes()[1].points[0]
  expect(u).toBeCloseTo(0.85)
  expect(v).toBeCloseTo(0.4)
  expect(strokes()[1].group).toBe('browRight')
  expect(strokes()[2]).toBe(OTHER)
})

test('all points that move along have a live mirror image', () => {
  const points = [0.1, 0.16, 0.22, 0.28, 0.34, 0.4].map((u): Uv => [u, 0.3])
  session.open(
    frozen({
      ...sampleDocument(),
      strokes: [{ ...strokeAt('browLeft', ...points), curve: 'spline' }, RIGHT],
    }),
  )
  editor.choose(strokes()[0])
  editor.point.value = 2
  for (const v of [0.33, 0.36, 0.4]) {
    editor.points.move([0.22, v])
    expect(strokes()[1].points.length).toBe(6)
    for (const [i, [u, own]] of strokes()[0].points.entries()) {
      const [mirrored, height] = strokes()[1].points[i]
      expect([mirrored, height]).toEqual([expect.closeTo(1 - u), expect.closeTo(own)])
    }
    expect(strokes().map((stroke) => editor.isMoving(stroke))).toEqual([true, true])
  }
  // The neighbours have moved too.
  expect(strokes()[0].points[3][1]).toBeGreaterThan(0.33)
  editor.settle()
  session.undo()
  expect(strokes()[1]).toEqual(RIGHT)
})

test('several chosen lines take all their counterparts along', () => {
  const strokesBefore = [LEFT, RIGHT, strokeAt('browLeft', [0.1, 0.6], [0.4, 0.6]), OTHER]
  session.open(frozen({ ...sampleDocument(), strokes: strokesBefore }))
  editor.choose(strokes()[0])
  editor.toggle(strokes()[2])
  editor.fields.setShape({ depth: 1 })
  expect(strokes().map(({ depth }) => depth)).toEqual([1, 1, 1, 1])
  editor.removeLine()
  expect(strokes()).toEqual([])
  session.undo()
  session.undo()
  expect(strokes()).toEqual(strokesBefore)
})

test('a deleted line takes its counterpart along, in one step', () => {
  editor.removeLine()
  expect(strokes().map(({ group }) => group)).toEqual(['browRight', 'brow'])
  session.undo()
  expect(strokes().length).toBe(4)
})

test('a line across the middle has no counterpart', () => {
  editor.choose(strokes()[3])
  editor.fields.setShape({ depth: 1 })
  expect(strokes().map(({ depth }) => depth)).toEqual([0.5, 0.5, 0.5, 1])
})

test('without the toggle only the chosen line changes', () => {
  editor.mirrored.value = false
  editor.fields.setShape({ depth: 1 })
  expect(strokes().map(({ depth }) => depth)).toEqual([1, 0.5, 0.5, 0.5])
})

test('a new region of a line gets its counterpart too', () => {
  editor.fields.setGroup('scarLeft')
  expect(strokes().map(({ group }) => group)).toEqual(['scarLeft', 'scarRight', 'browRight', 'brow'])
  const { areas } = session.document.value!
  expect(areas.slice(-2).map(({ name, activation }) => [name, activation])).toEqual([
    ['scarLeft', 1],
    ['scarRight', 1],
  ])
})

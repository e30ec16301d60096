import { beforeEach, describe, expect, test } from 'vitest'
import type { LayerStroke } from '../../../../studio/src/document/document.ts'
import type { LineEditor } from '../../../../studio/src/lines/line-editor.ts'
import { nextReach } from '../../../../studio/src/lines/line-points.ts'
import type { LineTool } from '../../../../studio/src/lines/line-tool.ts'
import { Session } from '../../../../studio/src/session/session.ts'
import { sampleDocument, strokeOf } from '../sample-document.ts'
import { at, editorOn, SIZE } from './sheet.ts'

/** Line across the sheet, with a point each 5 mm. */
const lineAt = (v: number): LayerStroke => ({
  ...strokeOf('down', 'frown'),
  curve: 'spline',
  points: Array.from({ length: 13 }, (_, i): [number, number] => [0.2 + 0.05 * i, v]),
})
const LINES = [lineAt(0.3), lineAt(0.5), lineAt(0.7)]

let session: Session
let editor: LineEditor
let tool: LineTool

beforeEach(() => {
  session = new Session()
  const sample = sampleDocument()
  const weights = { width: SIZE, height: SIZE, data: new Uint8Array(SIZE * SIZE).fill(255) }
  const areas = sample.areas.map((area) => ({ ...area, weights }))
  session.open({ ...sample, areaSize: SIZE, areas, strokes: LINES })
  ;({ editor, tool } = editorOn(session))
  editor.points.reach.value = 15
})

const strokes = () => session.document.value!.strokes
/** Motion of each point of a line downwards, millimetres. */
const sinking = (index: number) =>
  strokes()[index].points.map(([, v], i) => Math.round(1000 * (v - LINES[index].points[i][1])) / 10)
const SOFT = [0, 0, 0, 0, 2.6, 7.4, 10, 7.4, 2.6, 0, 0, 0, 0]
const ALONE = [0, 0, 0, 0, 0, 0, 10, 0, 0, 0, 0, 0, 0]

/** Drags the middle point of the first line by 10 mm. */
function drag({ alt = false } = {}): void {
  tool.begin(at(500, 300))
  for (const y of [350, 450, 400]) tool.move([{ ...at(500, y), alt }])
  tool.end()
}

describe('a dragged point', () => {
  beforeEach(() => editor.choose(strokes()[0]))

  test('takes its neighbours along, in one undo step', () => {
    drag()
    expect(sinking(0)).toEqual(SOFT)
    session.undo()
    expect(strokes()).toEqual(LINES)
    expect(session.undoLabel.value).toBeUndefined()
  })

  test('moves alone with Alt, and without reach', () => {
    drag({ alt: true })
    expect(sinking(0)).toEqual(ALONE)
    session.undo()
    editor.points.reach.value = 0
    drag()
    expect(sinking(0)).toEqual(ALONE)
  })

  test('takes its neighbours along when keys move it, step by step', () => {
    editor.point.value = 6
    for (const v of [0.32, 0.35, 0.4]) editor.points.move([0.5, v])
    editor.settle()
    expect(sinking(0)).toEqual(SOFT)
  })

  test('shows beforehand how much each point will move', () => {
    expect(editor.points.grabWeights(6).map((weight) => Math.round(100 * weight) / 10)).toEqual(SOFT)
    editor.points.reach.value = 0
    expect(editor.points.grabWeights(6).map((weight) => 10 * weight)).toEqual(ALONE)
  })

  test('extends the area to a neighbour that leaves it', () => {
    const data = new Uint8Array(SIZE * SIZE).fill(255)
    // A hole below the line, beside the dragged point.
    for (let y = 10; y < 14; y++) for (let x = 13; x < 15; x++) data[y * SIZE + x] = 0
    const weights = { width: SIZE, height: SIZE, data }
    const areaOf = () => session.document.value!.areas.find(({ name }) => name === 'frown')!
    session.open({ ...session.document.value!, areas: [{ ...areaOf(), weights }] })
    editor.choose(strokes()[0])
    tool.begin(at(500, 300))
    tool.move([at(500, 370)])
    tool.end()
    expect(areaOf().weights.data[11 * SIZE + 14]).toBeGreaterThan(100)
    session.undo()
    expect(areaOf().weights).toBe(weights)
  })
})

describe('a line that is dragged between its points', () => {
  const drag = (y: number) => {
    tool.begin(at(480, 301))
    tool.move([at(482, 303)])
    expect(strokes()).toEqual(LINES)
    for (const to of [y - 40, y]) tool.move([at(480, to)])
    tool.end()
  }

  test('is chosen and follows the pointer with its nearest point and its neighbours, in one undo step', () => {
    drag(401)
    expect(editor.chosen.value).toBe(strokes()[0])
    expect(sinking(0)).toEqual(SOFT)
    session.undo()
    expect(strokes()).toEqual(LINES)
    expect(session.undoLabel.value).toBeUndefined()
  })

  test('gets a point there if its points are far away, in the same undo step', () => {
    const strokesBefore = [{ ...LINES[0], points: [LINES[0].points[0], LINES[0].points[12]] }]
    session.open({ ...session.document.value!, strokes: strokesBefore })
    tool.begin(at(500, 301))
    tool.move([at(500, 401)])
    tool.end()
    expect(strokes()[0].points).toEqual([
      strokesBefore[0].points[0],
      [expect.closeTo(0.5, 2), expect.closeTo(0.4, 2)],
      strokesBefore[0].points[1],
    ])
    session.undo()
    expect(strokes()).toEqual(strokesBefore)
  })
})

describe('several chosen lines', () => {
  beforeEach(() => {
    editor.choose(strokes()[2])
    // Shift and a click add the second and the first line.
    for (const y of [502, 302]) {
      tool.begin(at(410, y, true))
      tool.end()
    }
    expect(editor.allChosen.value).toEqual([strokes()[0], strokes()[1], strokes()[2]])
  })

  test('move alike when a point of one is dragged, in one undo step', () => {
    drag()
    for (const index of [0, 1, 2]) expect(sinking(index)).toEqual(SOFT)
    expect(editor.allChosen.value.length).toBe(3)
    session.undo()
    expect(strokes()).toEqual(LINES)
    expect(session.undoLabel.value).toBeUndefined()
  })

  test('move alike when another of them is dragged', () => {
    tool.begin(at(480, 501))
    tool.move([at(480, 601)])
    tool.end()
    for (const index of [0, 1, 2]) expect(sinking(index)).toEqual(SOFT)
    expect(editor.allChosen.value.length).toBe(3)
  })

  test('lose one by another click with Shift, and all others by a click without', () => {
    tool.begin(at(410, 502, true))
    tool.end()
    expect(editor.allChosen.value).toEqual([strokes()[0], strokes()[2]])
    tool.begin(at(410, 502))
    tool.end()
    expect(editor.allChosen.value).toEqual([strokes()[1]])
  })

  test('get the same shape, in one undo step', () => {
    editor.fields.setShape({ depth: 0.8 })
    editor.fields.setShape({ depth: 0.9 })
    editor.settle()
    expect(strokes().map(({ depth }) => depth)).toEqual([0.9, 0.9, 0.9])
    expect(session.undoLabel.value).toBe('Change the depth of 3 lines')
    session.undo()
    expect(strokes()).toEqual(LINES)
  })

  test('are deleted in one undo step', () => {
    editor.toggle(strokes()[1])
    editor.remove()
    expect(strokes()).toEqual([expect.objectContaining({ points: LINES[1].points })])
    expect(editor.chosen.value).toBeNull()
    session.undo()
    expect(strokes()).toEqual(LINES)
  })

  test('are smoothed, mirrored, and given a layer and a region in one undo step each', () => {
    editor.smooth()
    expect(session.undoLabel.value).toBe('Smooth 3 lines')
    editor.fields.setLayer('up')
    expect(strokes().map(({ layer }) => layer)).toEqual(['up', 'up', 'up'])
    editor.fields.setGroup('scar')
    expect(strokes().map(({ group }) => group)).toEqual(['scar', 'scar', 'scar'])
    expect(session.document.value!.areas.filter(({ name }) => name === 'scar').length).toBe(1)
    editor.mirror()
    expect(strokes().length).toBe(6)
    expect(editor.allChosen.value).toEqual(strokes().slice(3))
    for (let n = 0; n < 4; n++) session.undo()
    expect(session.undoLabel.value).toBeUndefined()
  })

  test('keep their choice while one is dragged to a new depth, and lose it by a click', () => {
    editor.mode.value = 'select'
    tool.begin(at(410, 302))
    tool.move([at(410, 332)])
    tool.end()
    expect(strokes().map(({ depth }) => depth)).toEqual([0.8, 0.8, 0.8])
    expect(editor.allChosen.value.length).toBe(3)
    tool.begin(at(410, 302))
    tool.end()
    expect(editor.allChosen.value).toEqual([strokes()[0]])
  })

  test('leave the splitting of one line to that line', () => {
    editor.split()
    expect(strokes().length).toBe(4)
    expect(editor.allChosen.value).toEqual([strokes()[0]])
  })
})

test('a command chooses all lines of the region', () => {
  session.open({ ...session.document.value!, strokes: [...LINES, { ...LINES[0], group: 'cheeks' }] })
  editor.choose(strokes()[1])
  editor.chooseGroup()
  expect(editor.allChosen.value).toEqual([strokes()[1], strokes()[0], strokes()[2]])
})

test('a stroke over several lines smooths them in one undo step', () => {
  editor.mode.value = 'smooth'
  tool.begin(at(410, 302))
  tool.move([at(410, 502)])
  tool.end()
  expect(session.undoLabel.value).toBe('Smooth a line')
  session.undo()
  expect(session.undoLabel.value).toBeUndefined()
})

test('keys change the reach within its range', () => {
  expect([nextReach(15, 'larger'), nextReach(15, 'smaller')]).toEqual([17.5, 12.5])
  expect([nextReach(1, 'smaller'), nextReach(59, 'larger')]).toEqual([0, 60])
})

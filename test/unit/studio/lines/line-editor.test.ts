import { type SkinCanvas, skinCanvas, type Uv } from 'furrow/author'
import { StrokeLines } from 'furrow/internal'
import { beforeEach, describe, expect, test } from 'vitest'
import type { LayerStroke, StudioDocument } from '../../../../studio/src/document/document.ts'
import { LineEditor } from '../../../../studio/src/lines/line-editor.ts'
import { readSkin } from '../../../../studio/src/paint/read-skin.ts'
import { Session } from '../../../../studio/src/session/session.ts'
import { across } from '../../../strokes.ts'
import { plainSheet } from '../paint/skins.ts'
import { frozen, sampleDocument } from '../sample-document.ts'

const SIZE = 32

const canvas: SkinCanvas = skinCanvas(readSkin([plainSheet()]).skin, SIZE)
const lines = new StrokeLines(canvas)
let session: Session
let editor: LineEditor

beforeEach(() => {
  session = new Session()
  session.open(frozen(documentOn(SIZE)))
  editor = new LineEditor(session, () => ({ canvas, lines, middle: undefined }))
  editor.mode.value = 'edit'
})

/** Returns the sample with areas of another size. The first covers the upper half, and the others nothing. */
function documentOn(size: number): StudioDocument {
  const sample = sampleDocument()
  const areas = sample.areas.map((area, n) => {
    const data = new Uint8Array(size * size).map((_, i) => (n === 0 && i < (size * size) / 2 ? 255 : 0))
    return { ...area, weights: { width: size, height: size, data } }
  })
  const strokes = sample.strokes.map((stroke): LayerStroke => ({ ...stroke, isAutomatic: true }))
  return { ...sample, areaSize: size, areas, strokes }
}

const strokes = () => session.document.value!.strokes
const before = () => documentOn(SIZE).strokes

describe('a selected line', () => {
  beforeEach(() => editor.choose(strokes()[0]))

  test('is bent in one step, however often its point moves, stays selected and is no longer automatic', () => {
    editor.point.value = 0
    for (const v of [0.3, 0.35, 0.4]) editor.points.move([0.1, v])
    editor.settle()
    expect(strokes()[0]).toMatchObject({
      curve: 'spline',
      points: [
        [0.1, 0.4],
        [expect.closeTo(0.9), expect.closeTo(0.2)],
      ],
    })
    expect(editor.chosen.value).toBe(strokes()[0])
    expect(strokes().map(({ isAutomatic }) => isAutomatic)).toEqual([undefined, true, true])
    session.undo()
    expect(strokes()).toEqual(before())
    expect(editor.chosen.value).toBe(strokes()[0])
  })

  test('extends its area in the same step if a point is moved off the area', () => {
    const area = () => session.document.value!.areas[0]
    const at = ([u, v]: Uv) => area().weights.data[Math.floor(v * SIZE) * SIZE + Math.floor(u * SIZE)]
    editor.choose(strokes().find(({ group }) => group === area().name)!)
    const { weights } = area()
    editor.point.value = 0
    editor.points.move([0.2, 0.4])
    editor.settle()
    expect(area().weights).toBe(weights)
    expect(at([0.2, 0.8])).toBe(0)
    for (const v of [0.6, 0.7, 0.8]) editor.points.move([0.2, v])
    editor.settle()
    expect(at([0.2, 0.8])).toBeGreaterThan(200)
    // The area does not grow along the path of the pointer.
    expect(at([0.05, 0.6])).toBe(0)
    session.undo()
    expect(area().weights).toBe(weights)
    expect(editor.chosen.value!.points[0]).toEqual([0.2, 0.4])
  })

  test('is removed completely, whichever point is selected', () => {
    editor.point.value = 0
    const count = strokes().length
    expect(editor.handles.value.length).toBe(2)
    editor.removeLine()
    expect(strokes()).toHaveLength(count - 1)
    expect([editor.chosen.value, editor.point.value, editor.handles.value.length]).toEqual([null, -1, 0])
  })

  test('has one step for each gesture', () => {
    editor.point.value = 0
    editor.points.move([0.1, 0.3])
    editor.settle()
    editor.points.move([0.1, 0.4])
    editor.settle()
    session.undo()
    expect(strokes()[0].points[0]).toEqual([0.1, 0.3])
  })

  test('gets a point where it is clicked, and loses it again', () => {
    editor.points.insert(0.5)
    expect(strokes()[0].points.length).toBe(3)
    expect(editor.point.value).toBe(1)
    editor.remove()
    expect(strokes()[0].points.length).toBe(2)
    expect(strokes().length).toBe(3)
  })

  test('is removed if no point is selected, or if only two are left', () => {
    editor.point.value = 1
    editor.remove()
    expect(strokes()).toEqual(before().slice(1))
    expect(editor.chosen.value).toBeNull()
  })

  test('is split in its middle', () => {
    editor.split()
    expect(strokes().length).toBe(4)
    expect(strokes()[0].points.at(-1)![0]).toBeCloseTo(0.5, 2)
    expect(strokes()[1].points[0]).toEqual(strokes()[0].points.at(-1))
  })

  test('is mirrored: its mirror image is added and selected', () => {
    editor.point.value = 0
    editor.points.move([0.3, 0.2])
    editor.mirror()
    expect(strokes().length).toBe(4)
    expect(editor.chosen.value).toBe(strokes()[3])
    expect(strokes()[3].points.map(([u]) => u)).toEqual([expect.closeTo(0.7, 3), expect.closeTo(0.1, 3)])
  })

  test('has a shape that a slider changes in one step', () => {
    editor.fields.setShape({ width: 3 })
    editor.fields.setShape({ width: 4 })
    editor.settle()
    expect(strokes()[0].width).toBe(4)
    session.undo()
    expect(strokes()[0].width).toBe(2)
    expect(session.undoLabel.value).toBeUndefined()
  })

  test('can get banks, and lean to a side, in one step each', () => {
    editor.fields.setShape({ bank: [5, 5] })
    editor.fields.setShape({ bank: [6, 6] })
    editor.fields.setShape({ lean: -0.3 })
    editor.settle()
    expect(strokes()[0]).toMatchObject({ bank: [6, 6], lean: -0.3 })
    session.undo()
    expect(strokes()[0].lean).toBeUndefined()
    session.undo()
    expect(strokes()[0]).toEqual(before()[0])
    session.redo()
    expect(strokes()[0].bank).toEqual([6, 6])
  })

  test('makes an area with a new name, whose lines are visible at rest', () => {
    editor.fields.setGroup('scar')
    const area = session.document.value!.areas.at(-1)!
    expect(area).toMatchObject({ name: 'scar', layer: 'up', activation: 1 })
    expect(weightAt(area.weights, [0.5, 0.2])).toBe(255)
    expect(weightAt(area.weights, [0.5, 0.8])).toBe(0)
  })
})

describe('a drawn line', () => {
  beforeEach(() => {
    editor.mode.value = 'draw'
    editor.fields.setShape({ width: 5, depth: 1 })
  })

  test('belongs to the area under it and has the set shape', () => {
    editor.draw(across(0.3, 0.2, 0.8))
    expect(strokes()[3]).toMatchObject({
      group: 'forehead',
      layer: 'up',
      width: 5,
      depth: 1,
      curve: 'spline',
    })
    expect(editor.chosen.value).toBe(strokes()[3])
    expect(session.document.value!.areas.map(({ name }) => name)).toEqual(['forehead', 'frown', 'cheeks'])
    session.undo()
    expect(strokes()).toEqual(before())
  })

  test('gets a new area if none is under it', () => {
    editor.draw(across(0.8, 0.2, 0.8))
    expect(strokes()[3].group).toBe('lines')
    expect(session.document.value!.areas.at(-1)).toMatchObject({ name: 'lines', activation: 1 })
  })

  test('asks when it shows only if it was drawn on bare skin, until another line is chosen', () => {
    editor.draw(across(0.2, 0.2, 0.8))
    expect(editor.added.value).toEqual([])
    editor.draw(across(0.8, 0.2, 0.8))
    expect(editor.added.value).toEqual(['lines'])
    editor.choose(strokes()[0])
    expect(editor.added.value).toEqual([])
    // The second line on the same skin is in the area of the first.
    editor.draw(across(0.8, 0.2, 0.8))
    expect(editor.added.value).toEqual([])
  })

  test('extends the area that the artist named', () => {
    editor.fields.setGroup('frown')
    editor.draw(across(0.8, 0.2, 0.8))
    const { areas } = session.document.value!
    expect(strokes()[3]).toMatchObject({ group: 'frown', layer: 'down' })
    expect(areas.length).toBe(3)
    expect(weightAt(areas[1].weights, [0.5, 0.8])).toBe(255)
  })
})

test('a selected line is deselected when automatic wrinkles are made again', () => {
  editor.choose(strokes()[0])
  session.edit('Make automatic wrinkles', (document) => ({
    ...document,
    auto: { ...document.auto!, age: 60 },
  }))
  expect(editor.chosen.value).toBeNull()
})

function weightAt({ width, data }: { width: number; data: Uint8Array }, [u, v]: Uv): number {
  return data[Math.floor(v * width) * width + Math.floor(u * width)]
}

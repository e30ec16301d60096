import { beforeEach, describe, expect, test } from 'vitest'
import type { LayerStroke } from '../../../../studio/src/document/document.ts'
import { edited } from '../../../../studio/src/document/strokes.ts'
import type { LineEditor } from '../../../../studio/src/lines/line-editor.ts'
import { meanTaper } from '../../../../studio/src/lines/line-shape.ts'
import type { LineTool } from '../../../../studio/src/lines/line-tool.ts'
import { Session } from '../../../../studio/src/session/session.ts'
import { sampleDocument } from '../sample-document.ts'
import { at, editorOn, SIZE } from './sheet.ts'

let session: Session
let editor: LineEditor
let tool: LineTool

/** Returns an automatic line of the area `frown`. Its ends fade by 0.4. */
function line(points: [number, number][], more: Partial<LayerStroke> = {}): LayerStroke {
  const [, sample] = sampleDocument().strokes
  return { ...sample, curve: 'spline', isAutomatic: true, points, taper: [0.4, 0.4], ...more }
}

const TRUNK = line([
  [0.1, 0.4],
  [0.3, 0.4],
  [0.7, 0.4],
  [0.9, 0.4],
])
const BRANCH = line([[0.4, 0.1], [0.5, 0.4]], { taper: [0.4, 0] }) // biome-ignore format: one line
const OTHER = line([[0.5, 0.4], [0.6, 0.7]], { taper: [0, 0.4] }) // biome-ignore format: one line
const APART = line([[0.2, 0.8], [0.4, 0.8]]) // biome-ignore format: one line

beforeEach(() => {
  session = new Session()
  const sample = sampleDocument()
  const weights = { width: SIZE, height: SIZE, data: new Uint8Array(SIZE * SIZE).fill(255) }
  session.open({
    ...sample,
    areaSize: SIZE,
    areas: sample.areas.map((area) => ({ ...area, weights })),
    strokes: [TRUNK, BRANCH, OTHER, APART],
  })
  ;({ editor, tool } = editorOn(session))
})

function drag(from: readonly [number, number], ...path: readonly (readonly [number, number])[]): void {
  tool.begin(at(...from))
  for (const to of path) tool.move([at(...to)])
  tool.end()
}

const strokes = () => session.document.value!.strokes
const ends = () => [strokes()[1].points.at(-1), strokes()[2].points[0]]
const forkIndex = () => editor.handles.value.findIndex(({ fork }) => fork)
const close = ([u, v]: readonly number[]) => [expect.closeTo(u, 3), expect.closeTo(v, 3)]

describe('a fork', () => {
  test('is dragged with all lines that meet there, in one step, without choosing a line first', () => {
    drag([501, 399], [520, 420], [550, 450])
    expect(ends()).toEqual([
      [0.55, 0.45],
      [0.55, 0.45],
    ])
    expect(strokes()[0].points).toEqual([...TRUNK.points.slice(0, 2), [0.55, 0.45], ...TRUNK.points.slice(2)])
    expect(strokes().map(({ isAutomatic }) => isAutomatic)).toEqual([undefined, undefined, undefined, true])
    expect(editor.chosen.value).toBe(strokes()[0])
    expect(session.undoLabel.value).toBe('Move a fork')
    session.undo()
    expect(strokes()).toEqual([TRUNK, BRANCH, OTHER, APART])
    expect(session.undoLabel.value).toBeUndefined()
    session.redo()
    expect(ends()[1]).toEqual([0.55, 0.45])
  })

  test('is dragged by the end of a chosen branch too, again and again', () => {
    editor.choose(BRANCH)
    drag([500, 400], [550, 450])
    drag([550, 450], [560, 420])
    expect(ends()).toEqual([
      [0.56, 0.42],
      [0.56, 0.42],
    ])
    expect(strokes()[0].points.length).toBe(TRUNK.points.length + 1)
    session.undo()
    expect(ends()[0]).toEqual([0.55, 0.45])
  })

  test('is moved by the keyboard, as the point of its number', () => {
    editor.choose(TRUNK)
    expect(editor.handles.value.map(({ knot, fork }) => [knot, fork !== null])).toEqual([
      [0, false],
      [1, false],
      [-1, true],
      [2, false],
      [3, false],
    ])
    editor.point.value = 2
    editor.points.move([0.52, 0.4])
    editor.points.move([0.54, 0.4])
    editor.settle()
    expect(editor.point.value).toBe(2)
    expect(ends()).toEqual([
      [0.54, 0.4],
      [0.54, 0.4],
    ])
    expect(editor.handles.value[2]).toMatchObject({ knot: 2, fork: { trunks: [{ stroke: 0 }] } })
  })

  test('stays when its handle between two points of the trunk is deleted', () => {
    editor.choose(TRUNK)
    editor.point.value = 2
    editor.remove()
    expect(strokes()).toEqual([TRUNK, BRANCH, OTHER, APART])
  })

  test('splits its trunk there', () => {
    editor.choose(TRUNK)
    editor.point.value = 2
    editor.split()
    expect(strokes()[0].points.at(-1)).toEqual([expect.closeTo(0.5, 2), expect.closeTo(0.4)])
    expect(strokes().length).toBe(5)
  })

  test('extends the areas of its lines when it is moved off them', () => {
    session.edit('', (document) => ({
      ...document,
      areas: document.areas.map((area) => {
        const data = area.weights.data.map((_, i) => (i < (SIZE * SIZE) / 2 ? 255 : 0))
        return { ...area, weights: { ...area.weights, data } }
      }),
    }))
    drag([500, 400], [500, 900])
    const { data } = session.document.value!.areas[1].weights
    expect(data[Math.floor(0.9 * SIZE) * SIZE + Math.floor(0.5 * SIZE)]).toBeGreaterThan(200)
    session.undo()
    expect(ends()[0]).toEqual([0.5, 0.4])
  })
})

describe('a trunk', () => {
  test('takes its branches along when a point of it is moved', () => {
    editor.choose(TRUNK)
    drag([300, 400], [300, 500])
    const [end, start] = ends()
    expect(end![1]).toBeGreaterThan(0.42)
    expect(start).toEqual(close(end!))
    expect(editor.forks.value.length).toBe(1)
    session.undo()
    expect(strokes()).toEqual([TRUNK, BRANCH, OTHER, APART])
  })

  test('takes them along when it is smoothed or loses a point', () => {
    editor.choose(TRUNK)
    drag([300, 400], [300, 500])
    const [bent] = ends()
    editor.smooth()
    const [end, start] = ends()
    expect(end).not.toEqual(bent)
    expect(start).toEqual(close(end!))
    expect(editor.forks.value.length).toBe(1)
    session.undo()
    editor.point.value = 1
    editor.remove()
    expect(ends()[0]).toEqual([expect.closeTo(0.5, 2), expect.closeTo(0.4)])
    expect(editor.forks.value.length).toBe(1)
  })

  test('leaves its branches where they are when it is deleted', () => {
    editor.choose(TRUNK)
    editor.removeLine()
    expect(strokes()).toEqual([BRANCH, OTHER, APART].map(edited))
  })
})

describe('a branch', () => {
  test('leaves the trunk and other branches when it is deleted', () => {
    editor.choose(BRANCH)
    editor.removeLine()
    expect(strokes()).toEqual([TRUNK, OTHER, APART].map(edited))
  })

  test('is detached: it ends before the trunk, fades there, and can be moved alone', () => {
    editor.choose(BRANCH)
    editor.detach()
    expect(session.undoLabel.value).toBe('Detach a line')
    const [trunk, detached, other] = strokes()
    expect([trunk, other]).toEqual([TRUNK, OTHER])
    const [u, v] = detached.points.at(-1)!
    expect(Math.hypot(100 * (u - 0.5), 100 * (v - 0.4))).toBeCloseTo(2, 0)
    expect(detached.taper[1]).toBe(0.4)
    expect(editor.attachedEnds.value).toEqual([])
    drag([1000 * u, 1000 * v], [450, 300])
    expect(strokes()[0]).toEqual(TRUNK)
    expect(ends()).toEqual([
      [0.45, 0.3],
      [0.5, 0.4],
    ])
  })

  test('keeps the taper of its end in the fork when the taper of the line is set', () => {
    editor.choose(BRANCH)
    editor.fields.setShape({ taper: [0.2, 0.2] })
    expect(strokes()[1].taper).toEqual([0.2, 0])
    expect(meanTaper(strokes()[1], editor.attachedEnds.value)).toBe(0.2)
    editor.choose(APART)
    editor.fields.setShape({ taper: [0.2, 0.2] })
    expect(strokes()[3].taper).toEqual([0.2, 0.2])
  })
})

test('a line that is dragged across another line does not join it on the way', () => {
  editor.choose(APART)
  drag([400, 800], [400, 500], [500, 400], [600, 300])
  expect(strokes().slice(0, 3)).toEqual([TRUNK, BRANCH, OTHER])
  expect(strokes()[3].points.at(-1)).toEqual([0.6, 0.3])
})

test('a line joins another one when its end is dropped on it', () => {
  editor.choose(APART)
  drag([400, 800], [300, 400])
  expect(editor.forks.value.length).toBe(2)
  expect(forkIndex()).toBe(1)
  drag([300, 400], [300, 300])
  expect(strokes()[0].points[1]).toEqual([0.3, 0.3])
})

import { beforeEach, expect, it, vi } from 'vitest'
import type { StudioArea } from '../../../../studio/src/document/document.ts'
import { fillArea } from '../../../../studio/src/lines/fill-area.ts'
import { FillOffer } from '../../../../studio/src/lines/fill-offer.ts'
import { AreaEditor } from '../../../../studio/src/session/area-editor.ts'
import { Session } from '../../../../studio/src/session/session.ts'
import { attempts, frozen, sampleDocument } from '../sample-document.ts'
import { canvas, SIZE } from './sheet.ts'

/** Weights of 255 in the rows of the area, otherwise of 0. */
function areaOf(name: string, from: number, to: number): StudioArea {
  const data = Uint8Array.from({ length: SIZE * SIZE }, (_, i) =>
    i >= from * SIZE && i < to * SIZE ? 255 : 0,
  )
  const weights = { width: SIZE, height: SIZE, data }
  return { name, layer: 'up', combine: 'sum', activation: 0, weights }
}

let session: Session
let areas: AreaEditor
let fill: FillOffer
let errors: string[]

beforeEach(() => {
  session = new Session()
  const tried = attempts()
  errors = tried.errors
  areas = new AreaEditor(session, tried.attempt)
  session.open(frozen({ ...sampleDocument(), areaSize: SIZE, areas: [areaOf('new', 16, 28)], drivers: [] }))
  areas.choose('new')
  const attempt = async (task: () => unknown) =>
    Promise.resolve(task()).catch((error) => errors.push(error.message))
  fill = new FillOffer({ session, areas, canvas: async () => canvas, onFilled: () => {}, attempt })
})

it('painted skin without lines is filled in one undo step, and is then visible', async () => {
  const before = session.document.value!
  expect(fill.offered.value).toBeNull()
  fill.painted('new')
  expect(fill.offered.value).toBe('new')
  fill.fill()
  await vi.waitFor(() => expect(session.undoLabel.value).toBe('Fill New with lines'))
  const { strokes, areas: filled } = session.document.value!
  const added = strokes.slice(before.strokes.length)
  expect(added.length).toBeGreaterThan(1)
  for (const { layer, group, points, isAutomatic } of added) {
    expect([layer, group, isAutomatic]).toEqual(['up', 'new', undefined])
    expect(points.every(([, v]) => v > 15 / SIZE && v < 29 / SIZE)).toBe(true)
  }
  expect(filled[0].activation).toBe(1)
  expect(fill.offered.value).toBeNull()
  session.undo()
  expect(session.document.value).toBe(before)
})

it('a region that is activated keeps its activation', () => {
  const [area] = session.document.value!.areas
  const document = { ...session.document.value!, areas: [{ ...area, activation: 0.3 }] }
  expect(fillArea(document, 'new', canvas).areas[0].activation).toBe(0.3)
})

it('nothing is offered for a region that has lines, is empty, or is not selected', () => {
  const document = session.document.value!
  const [stroke] = document.strokes
  const crossing = { ...stroke, points: stroke.points.map(([u]): [number, number] => [u, 0.7]) }
  session.open({ ...document, strokes: [crossing] })
  fill.painted('new')
  expect(fill.offered.value).toBeNull()
  session.open({ ...document, strokes: [{ ...crossing, layer: 'down' }] })
  expect(fill.offered.value).toBe('new')
  session.open({ ...document, areas: [areaOf('new', 0, 0)] })
  expect(fill.offered.value).toBeNull()
  session.open(document)
  areas.choose(null)
  expect(fill.offered.value).toBeNull()
})

it('a refused region is not offered again', () => {
  fill.painted('new')
  fill.refuse()
  fill.painted('new')
  expect(fill.offered.value).toBeNull()
})

it('a region that is too small is reported, and the document stays', async () => {
  const small = areaOf('new', 0, 0)
  small.weights.data[500] = 255
  session.open({ ...session.document.value!, areas: [small] })
  fill.painted('new')
  fill.fill()
  await vi.waitFor(() => expect(errors).toEqual([expect.stringContaining('too small for lines')]))
  expect(session.undoLabel.value).toBeUndefined()
})

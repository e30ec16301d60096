import fc from 'fast-check'
import { parseDrivers } from 'furrow'
import { describe, expect, it } from 'vitest'
import * as areas from '../../../studio/src/document/areas.ts'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { recordPose, removeDriver } from '../../../studio/src/document/drivers.ts'
import { History } from '../../../studio/src/document/history.ts'
import * as layers from '../../../studio/src/document/layers.ts'
import { addStroke, removeStroke } from '../../../studio/src/document/strokes.ts'
import { frozen, sampleDocument, strokeOf, weightsOf } from './sample-document.ts'

const AREAS = ['forehead', 'frown', 'cheeks', 'nose', 'chin', 'cheeks 2']
const LAYERS = ['up', 'down', 'left', 'right', 'more']

interface Operation {
  name: string
  run: (document: StudioDocument) => StudioDocument
}

const area = fc.constantFrom(...AREAS)
const layer = fc.constantFrom(...LAYERS)
const fraction = fc.double({ min: 0, max: 1, noNaN: true })

function operation<T>(
  name: string,
  values: fc.Arbitrary<T>,
  run: (document: StudioDocument, values: T) => StudioDocument,
): fc.Arbitrary<Operation> {
  return values.map((value) => ({ name, run: (document) => run(document, value) }))
}

/** Random operations, whose arguments may be invalid for the document. */
const operations: fc.Arbitrary<Operation> = fc.oneof(
  operation('add', area, areas.addEmptyArea),
  operation('remove', area, areas.removeArea),
  operation('duplicate', area, areas.duplicateArea),
  operation('rename', fc.tuple(area, area), (d, [from, to]) => areas.renameArea(d, from, to)),
  operation('move', fc.tuple(area, layer), (d, [name, to]) => areas.setArea(d, name, { layer: to })),
  operation('paint', fc.tuple(area, fc.nat(255)), (d, [name, v]) => areas.paintArea(d, name, weightsOf(v))),
  operation('add layer', layer, layers.addLayer),
  operation('remove layer', layer, layers.removeLayer),
  operation('rename layer', fc.tuple(layer, layer), (d, [from, to]) => layers.renameLayer(d, from, to)),
  operation('order', fc.tuple(layer, fc.nat(4)), (d, [name, i]) => layers.moveLayer(d, name, i)),
  operation('set', fc.tuple(layer, fraction), (d, [n, s]) => layers.setLayer(d, n, { normalScale: s })),
  operation('draw', fc.tuple(layer, area), (d, [on, group]) => addStroke(d, strokeOf(on, group))),
  operation('erase', fc.nat(9), (d, i) => (d.strokes[i] ? removeStroke(d, d.strokes[i]) : d)),
  operation('record', fc.tuple(area, fraction), (d, [name, w]) => recordPose(d, name, new Map([['jaw', w]]))),
  operation('remove driver', fc.nat(9), removeDriver),
)

/** Returns the result of an operation, or the same document if the operation is refused. */
function tried(document: StudioDocument, run: Operation['run']): StudioDocument {
  try {
    return frozen(run(document))
  } catch (error) {
    expect(error).toMatchObject({ name: 'FurrowError', who: 'Studio' })
    return document
  }
}

/** Checks that a document names only layers, areas and strokes that it has. */
function checkNames({ areas, layers, strokes, drivers, strokeAreas = [] }: StudioDocument): void {
  const areaNames = areas.map(({ name }) => name)
  const layerNames = layers.map(({ name }) => name)
  expect(new Set(areaNames).size).toBe(areas.length)
  expect(new Set(layerNames).size).toBe(layers.length)
  for (const { layer } of [...areas, ...strokes]) expect(layerNames).toContain(layer)
  for (const { name } of strokeAreas) expect(areaNames).toContain(name)
  expect(parseDrivers(drivers, areaNames)).toEqual(drivers)
}

const SEED = { seed: 16, numRuns: 200 }

describe('any sequence of operations', () => {
  it('does not modify a document, and leaves no names of removed items', () => {
    fc.assert(
      fc.property(fc.array(operations, { maxLength: 40 }), (sequence) => {
        let document = frozen(sampleDocument())
        for (const { run } of sequence) document = tried(document, run)
        checkNames(document)
      }),
      SEED,
    )
  })

  it('can be undone back to the start, and redone to the same documents', () => {
    const step = fc.tuple(operations, fc.constantFrom(undefined, 'a', 'b'))
    fc.assert(
      fc.property(fc.array(step, { maxLength: 60 }), (steps) => {
        const start = frozen(sampleDocument())
        const history = new History(start)
        for (const [{ name, run }, key] of steps) history.push(name, tried(history.document, run), key)
        const seen = [history.document]
        while (history.undoLabel !== undefined) {
          history.undo()
          seen.push(history.document)
        }
        expect(history.document).toBe(start)
        for (const document of seen.toReversed().slice(1)) {
          history.redo()
          expect(history.document).toBe(document)
        }
        expect(history.redoLabel).toBeUndefined()
      }),
      SEED,
    )
  })
})

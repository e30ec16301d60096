import { describe, expect, it } from 'vitest'
import {
  type DocumentRecord,
  documentOf,
  type ImageRecord,
  imagesOf,
  recordOf,
} from '../../../studio/src/keep/document-record.ts'
import { sampleDocument } from './sample-document.ts'

const document = sampleDocument()
const images = [...imagesOf(document)]
const byNumber = new Map<number, ImageRecord>(images.map((image, i) => [i, image]))
const record = (): DocumentRecord => structuredClone(recordOf(document, (image) => images.indexOf(image)))

const open = (changed: unknown) => documentOf(changed as DocumentRecord, byNumber, 'Face')

/** Returns a record with one field of the document replaced. */
function withField(path: readonly (string | number)[], value: unknown): unknown {
  const changed = record()
  let at = changed.document as unknown as Record<string | number, unknown>
  for (const key of path.slice(0, -1)) at = at[key] as Record<string | number, unknown>
  at[path.at(-1)!] = value
  return changed
}

describe('the record of a document', () => {
  it('is read as the stored document', () => {
    expect(open(record())).toEqual(document)
  })

  it.each([
    [['layers'], 5],
    [['layers', 0], null],
    [['layers', 0, 'maps'], { normal: 'x' }],
    [['layers', 0, 'normalScale'], Number.NaN],
    [['layers', 1, 'sculpted'], { size: 64, tiles: [[1, 0]] }],
    [['layers', 1, 'sculpted', 'size'], 0],
    [['areas', 0, 'activation'], 2],
    [['areas', 0, 'layer'], 'gone'],
    [['areas', 0, 'name'], {}],
    [['strokes'], {}],
    [['strokes', 0], 7],
    [['strokes', 0, 'points'], [[0]]],
    [['strokeAreas'], [{ name: 'forehead', shapes: 3 }]],
    [['furrows'], 'deep'],
    [['drivers'], [{ type: 'morph' }]],
    [['shapes'], [{ target: 'key_1', shape: 'browUpward' }]],
    [['takes'], {}],
    [['takes', 0, 'names'], []],
    [['takes', 0, 'weights'], -1],
    [
      ['takes', 1, 'range'],
      [1, 0],
    ],
    [['auto'], 5],
    [['auto', 'seed'], -1],
    [['scale'], '1000'],
    [['mapSize'], 1e9],
    [['areaSize'], undefined],
    [['mesh'], []],
  ])('throws one error if %j is %j', (path, value) => {
    expect(() => open(withField(path, value))).toThrow(/^Studio: cannot open Face \(its document/)
  })

  it.each([undefined, null, 5, {}, { version: 1 }, { version: 1, document: [] }])(
    'is refused with one kind of error if it is %j',
    (value) => {
      expect(() => open(value)).toThrow(/^Studio: /)
    },
  )
})

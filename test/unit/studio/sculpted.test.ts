import { describe, expect, it } from 'vitest'
import { remake } from '../../../studio/src/document/automatic.ts'
import { setSculpted } from '../../../studio/src/document/layers.ts'
import {
  heightMapOf,
  imageOf,
  sculptedOf,
  sculptedSize,
  withImage,
} from '../../../studio/src/document/sculpted.ts'
import { sculptedChanges } from '../../../studio/src/draw/changes.ts'
import { SculptedSheet } from '../../../studio/src/draw/sculpted-sheet.ts'
import { readProject } from '../../../studio/src/export/read-document.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { opened, projectFiles } from './project-files.ts'
import { frozen, sampleDocument, sculptedAt } from './sample-document.ts'

const SIZE = 160

/** Image that is `height` micrometres high in a rectangle. */
function raised(x: number, y: number, width: number, height: number, step: number) {
  const data = new Int16Array(SIZE ** 2)
  for (let row = y; row < y + height; row++) data.fill(step, row * SIZE + x, row * SIZE + x + width)
  return { width: SIZE, height: SIZE, data }
}

const flat = { size: SIZE, tiles: new Map() }
const [one, two] = [raised(60, 10, 10, 10, 500), raised(150, 150, 10, 10, -300)]

describe('sculpted heights', () => {
  it('are tiles of an image, also at borders, without flat tiles', () => {
    const sculpted = withImage(flat, one)
    expect([...sculpted.tiles.keys()]).toEqual([0, 1])
    expect(imageOf(sculpted)).toEqual(one)
    expect([...withImage(flat, two).tiles.keys()]).toEqual([8])
    expect(imageOf(withImage(flat, two))).toEqual(two)
  })

  it('keep the tiles that a change does not touch, and lose those that become flat', () => {
    const before = withImage(withImage(flat, one), { ...two, data: two.data.map((v, i) => v || one.data[i]) })
    const rectangle = { x: 150, y: 150, width: 10, height: 10 }
    const after = withImage(before, raised(0, 0, 0, 0, 0), rectangle)
    expect([...after.tiles.keys()]).toEqual([0, 1])
    for (const [index, tile] of after.tiles) expect(tile).toBe(before.tiles.get(index))
  })

  it('are the same after a conversion to millimetres and back', () => {
    const sculpted = withImage(flat, one)
    expect(heightMapOf(sculpted).data[10 * SIZE + 60]).toBeCloseTo(0.5, 6)
    expect(sculptedOf(heightMapOf(sculpted))).toEqual(sculpted)
  })

  it('have at most 2048 texels per side', () => {
    expect([512, 2048, 4096].map(sculptedSize)).toEqual([512, 2048, 2048])
  })

  it('undo and redo restore them exactly, and a stroke of several changes is one step', () => {
    const session = new Session()
    session.open(frozen(sampleDocument()))
    const before = session.document.value
    session.edit('Sculpt', (old) => setSculpted(old, 'up', sculptedAt(5)), 'sculpt')
    session.edit('Sculpt', (old) => setSculpted(old, 'up', sculptedAt(6)), 'sculpt')
    session.settle()
    const after = session.document.value
    session.undo()
    expect(session.document.value).toBe(before)
    session.redo()
    expect(session.document.value).toBe(after)
    session.edit('Reset', (old) => setSculpted(old, 'up', null))
    expect(session.document.value!.layers[0]).toEqual(sampleDocument().layers[0])
  })

  it('stay when the strokes of their layer are removed, and when wrinkles are made again', () => {
    const document = sampleDocument()
    const made = {
      ...document,
      layers: document.layers.map(({ sculpted: _, ...layer }) => layer),
      mapSize: 128,
    }
    const again = remake({ ...document, strokes: [] }, made)
    expect(again.layers.find(({ name }) => name === 'down')!.sculpted).toBe(document.layers[1].sculpted)
    expect(again.mapSize).toBe(64)
  })

  it('are in the project, and a project without them has the same files as before', async () => {
    const document = sampleDocument()
    const files = projectFiles({ document, drawn: new Map() })
    const entry = JSON.parse(new TextDecoder().decode(files.get('wrinkles.json')!)).layers[1]
    expect(entry.sculpted).toBe('layers/down/sculpted.png')
    const { layers } = (await readProject(opened(files), 'Face')).document
    expect(layers[1].sculpted).toEqual(document.layers[1].sculpted)
    const plain = projectFiles({ document: setSculpted(document, 'down', null), drawn: new Map() })
    expect([...plain.keys()]).toEqual([...files.keys()].filter((path) => path !== 'layers/down/sculpted.png'))
    expect(new TextDecoder().decode(plain.get('wrinkles.json')!)).not.toContain('sculpted')
  })
})

describe('the worker', () => {
  it('receives only the tiles that have changed, and draws them into its heights', () => {
    const [before, after] = [
      withImage(flat, one),
      withImage(withImage(flat, two), one, { x: 0, y: 0, width: 64, height: 64 }),
    ]
    const sheet = new SculptedSheet(SIZE)
    expect(sheet.update(sculptedChanges(null, before)!)).toEqual([{ x0: 0, y0: 0, x1: 128, y1: 64 }])
    expect(sheet.heights).toEqual(heightMapOf(before))
    const changes = sculptedChanges(before, after)!
    expect([...changes.tiles.keys()].sort()).toEqual([0, 1, 8])
    sheet.update(changes)
    expect(sheet.heights).toEqual(heightMapOf(after))
    expect(sculptedChanges(after, after)).toBeNull()
    sheet.update(sculptedChanges(after, null)!)
    expect(sheet.heights.data.every((mm) => mm === 0)).toBe(true)
  })

  it('resamples heights to larger maps', () => {
    const sheet = new SculptedSheet(2 * SIZE)
    sheet.update(sculptedChanges(null, withImage(flat, one))!)
    expect(sheet.heights.data[30 * 2 * SIZE + 130]).toBeCloseTo(0.5, 6)
    expect(sheet.heights.data[30 * 2 * SIZE + 150]).toBe(0)
  })
})

import { beforeEach, expect, it, test } from 'vitest'
import { importMap } from '../../../studio/src/document/import-map.ts'
import { addLayer } from '../../../studio/src/document/layers.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { areaOf, frozen, sampleDocument, weightsOf } from './sample-document.ts'

const IMAGE = { mimeType: 'image/png', bytes: Uint8Array.of(1) }
let session: Session

beforeEach(() => {
  session = new Session()
  session.open(frozen(addLayer(sampleDocument(), 'new')))
})

const imported = (layer: string, map: 'normal' | 'height' | 'blood') => {
  session.edit('Import', (document) => importMap(document, layer, map, IMAGE))
  return session.document.value!
}

it('a map of a layer that nothing shows gets an area over the whole skin, in one undo step', () => {
  const before = session.document.value!
  const { areas } = imported('new', 'normal')
  const size = before.areaSize ** 2
  expect(areas.at(-1)).toEqual({
    name: 'wholeSkin',
    layer: 'new',
    combine: 'sum',
    activation: 1,
    weights: { ...weightsOf(0), data: new Uint8Array(size).fill(255) },
  })
  session.undo()
  expect(session.document.value).toBe(before)
})

it('a layer that an area shows gets no other area', () => {
  expect(imported('up', 'normal').areas).toHaveLength(3)
})

test.each([
  ['an empty area', areaOf('empty', 'new', 0), 5],
  ['an area without activation', areaOf('still', 'new'), 5],
  ['an area that is always visible', { ...areaOf('shown', 'new'), activation: 0.5 }, 4],
])('with %s in the layer, the document then has %3$i areas', (_, area, count) => {
  session.edit('Add', (document) => ({ ...document, areas: [...document.areas, area] }))
  expect(imported('new', 'normal').areas).toHaveLength(count)
})

it('heights and blood get an amplitude, and keep one that the layer has', () => {
  const layer = () => session.document.value!.layers.at(-1)!
  imported('new', 'height')
  expect(layer().heightAmplitude).toBe(0.002)
  session.edit('Set', ({ layers, ...rest }) => ({
    ...rest,
    layers: layers.map((each) => ({ ...each, heightAmplitude: 0.005 })),
  }))
  imported('new', 'height')
  expect(layer().heightAmplitude).toBe(0.005)
  imported('new', 'blood')
  expect(layer().bloodAmplitude).toBe(0.3)
})

import { describe, expect, it } from 'vitest'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import type { HeightImage } from '../../../studio/src/document/sculpted.ts'
import {
  addSculptedLayer,
  coverSculpted,
  type SculptPlace,
  sculptPlace,
} from '../../../studio/src/document/sculpted-area.ts'
import { frozen, sampleDocument, weightsOf } from './sample-document.ts'

/** Document whose area `forehead` covers the upper half of the skin, and a blood area all of it. */
function documentOf(): StudioDocument {
  const document = sampleDocument()
  const [forehead, frown] = document.areas
  const weights = weightsOf(0)
  weights.data.fill(255, 0, 8)
  const flush = { ...frown, name: 'flushCheek', weights: weightsOf(255) }
  return frozen({ ...document, drivers: [], areas: [{ ...forehead, weights }, flush] })
}

const SIZE = 16
const before = { width: SIZE, height: SIZE, data: new Int16Array(SIZE ** 2) }
const changed = { x: 0, y: 0, width: SIZE, height: SIZE }

/** Heights that are sculpted at one texel. */
function at(x: number, y: number) {
  const data = new Int16Array(SIZE ** 2)
  data[y * SIZE + x] = 100
  return { ...before, data }
}

/** Adds the layer and the area of a stroke. */
const sculpt = (document: StudioDocument, place: SculptPlace, after: HeightImage) =>
  coverSculpted(addSculptedLayer(document, place), place, before, after, changed)

describe('a stroke that sculpts', () => {
  it('belongs to the chosen area', () => {
    const document = documentOf()
    expect(sculptPlace(document, document.areas[0], [0.5, 0.9])).toEqual({ layer: 'up', area: 'forehead' })
    expect(sculptPlace(document, document.areas[1], [0.5, 0.1]).area).toBe('flushCheek')
  })

  it('belongs to an always visible area in a layer of its own if none is chosen, and the next one to the same area', () => {
    const document = documentOf()
    const place = sculptPlace(document, null, [0.5, 0.1])
    expect(place).toEqual({ layer: 'sculpted', area: 'sculpted' })
    const covered = sculpt(document, place, at(0, 15))
    expect(covered.layers.map(({ name }) => name)).toEqual([
      ...document.layers.map(({ name }) => name),
      'sculpted',
    ])
    const { activation, layer, weights } = covered.areas.find(({ name }) => name === 'sculpted')!
    expect([activation, layer, weights.data[12], weights.data[15]]).toEqual([1, 'sculpted', 255, 0])
    expect(sculptPlace(covered, null, [0.9, 0.9])).toEqual(place)
  })

  it('belongs to the area of wrinkles under its start if there is no room for a layer', () => {
    const { layers, ...others } = documentOf()
    const full = ['up', 'b', 'c', 'd'].map((name) => ({ ...layers[0], name }))
    const document = { ...others, layers: full }
    expect(sculptPlace(document, null, [0.5, 0.1])).toEqual({ layer: 'up', area: 'forehead' })
    expect(sculptPlace(document, null, [0.5, 0.9])).toEqual({ layer: 'up', area: 'sculpted' })
  })

  it('adds another area if an expression shows the last one', () => {
    const document = documentOf()
    const place = sculptPlace(document, null, [0.5, 0.9])
    const { areas, ...others } = sculpt(document, place, at(0, 15))
    const posed = { ...others, areas: areas.map((area) => ({ ...area, activation: 0 })) }
    expect(sculptPlace(posed, null, [0.9, 0.9])).toEqual({ layer: 'sculpted', area: 'sculpted 2' })
  })

  it('does not change an area that shows it', () => {
    const document = documentOf()
    const place = sculptPlace(document, document.areas[0], [0.5, 0.1])
    expect(coverSculpted(document, place, before, at(8, 2), changed)).toBe(document)
  })

  it('extends its area where the layer is not shown, and marks the area as edited', () => {
    const document = documentOf()
    const automatic = { ...document, areas: document.areas.map((area) => ({ ...area, isAutomatic: true })) }
    const place = sculptPlace(document, document.areas[0], [0.5, 0.1])
    const [area] = coverSculpted(automatic, place, before, at(15, 15), changed).areas
    expect([...area.weights.data]).toEqual([...Array(8).fill(255), 0, 0, 255, 255, 0, 0, 255, 255])
    expect(area.isAutomatic).toBeUndefined()
  })
})

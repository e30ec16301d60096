import { describe, expect, it } from 'vitest'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { coverSculpted, sculptPlace } from '../../../studio/src/document/sculpted-area.ts'
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

describe('a stroke that sculpts', () => {
  it('belongs to the chosen area, or to the area of wrinkles under its start', () => {
    const document = documentOf()
    expect(sculptPlace(document, null, [0.5, 0.1])).toEqual({ layer: 'up', area: 'forehead' })
    expect(sculptPlace(document, document.areas[1], [0.5, 0.1]).area).toBe('flushCheek')
  })

  it('on bare skin belongs to an area that is always visible, and the next one to the same area', () => {
    const document = documentOf()
    const place = sculptPlace(document, null, [0.5, 0.9])
    expect(place).toEqual({ layer: 'up', area: 'sculpted' })
    const covered = coverSculpted(document, place, before, at(0, 15), changed)
    const { activation, layer, weights } = covered.areas.find(({ name }) => name === 'sculpted')!
    expect([activation, layer, weights.data[12], weights.data[15]]).toEqual([1, 'up', 255, 0])
    expect(sculptPlace(covered, null, [0.9, 0.9]).area).toBe('sculpted')
  })

  it('adds another area if an expression shows the last one', () => {
    const document = documentOf()
    const place = sculptPlace(document, null, [0.5, 0.9])
    const { areas, ...others } = coverSculpted(document, place, before, at(0, 15), changed)
    const posed = { ...others, areas: areas.map((area) => ({ ...area, activation: 0 })) }
    expect(sculptPlace(posed, null, [0.9, 0.9]).area).toBe('sculpted 2')
  })

  it('does not change an area that shows it', () => {
    const document = documentOf()
    const place = sculptPlace(document, null, [0.5, 0.1])
    expect(coverSculpted(document, place, before, at(8, 2), changed)).toBe(document)
  })

  it('extends its area where the layer is not shown, and marks the area as edited', () => {
    const document = documentOf()
    const automatic = { ...document, areas: document.areas.map((area) => ({ ...area, isAutomatic: true })) }
    const place = sculptPlace(document, null, [0.5, 0.1])
    const [area] = coverSculpted(automatic, place, before, at(15, 15), changed).areas
    expect([...area.weights.data]).toEqual([...Array(8).fill(255), 0, 0, 255, 255, 0, 0, 255, 255])
    expect(area.isAutomatic).toBeUndefined()
  })
})

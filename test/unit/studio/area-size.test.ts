import { beforeEach, expect, it } from 'vitest'
import { areaCost, setAreaSize } from '../../../studio/src/document/area-size.ts'
import { addEmptyArea } from '../../../studio/src/document/areas.ts'
import { remake } from '../../../studio/src/document/automatic.ts'
import { AreaEditor } from '../../../studio/src/session/area-editor.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { attempts, frozen, sampleDocument } from './sample-document.ts'

let session: Session
let areas: AreaEditor

beforeEach(() => {
  session = new Session()
  areas = new AreaEditor(session, attempts().attempt)
  session.open(frozen(sampleDocument()))
})

it('a new size resamples all areas in one step, and undo restores the same weights', () => {
  const before = session.document.value!
  areas.resize(256)
  const { areaSize, areas: resized } = session.document.value!
  expect(areaSize).toBe(256)
  for (const { weights } of resized) {
    expect([weights.width, weights.height, weights.data.length]).toEqual([256, 256, 256 ** 2])
    expect(weights.data.every((weight) => weight === 100)).toBe(true)
  }
  session.undo()
  expect(session.document.value).toBe(before)
})

it('new areas have the size of the document', () => {
  areas.resize(256)
  expect(addEmptyArea(session.document.value!, 'new').areas.at(-1)!.weights.width).toBe(256)
  areas.add({ name: 'image', weights: { width: 2, height: 2, data: new Uint8Array(4) } })
  expect(session.document.value!.areas.at(-1)!.weights.width).toBe(256)
})

it('automatic wrinkles that were made for another size get the size of the document', () => {
  const document = setAreaSize(sampleDocument(), 8)
  const automatic = sampleDocument().areas.map((area) => ({ ...area, name: `${area.name}Left` }))
  const { areas, areaSize } = remake(document, { ...sampleDocument(), areas: automatic })
  expect(areaSize).toBe(8)
  expect(areas.map(({ weights }) => weights.width)).toEqual(Array(6).fill(8))
})

it('the cost counts the texels of areas and of the influence map', () => {
  const document = sampleDocument()
  const half = { width: 4, height: 4, data: Uint8Array.from({ length: 16 }, (_, i) => (i < 8 ? 255 : 0)) }
  const [first, ...others] = document.areas
  const { bytes, texels } = areaCost({ ...document, areas: [{ ...first, weights: half }, ...others] })
  // Three areas of one byte per texel, and a map of two layers with two floats per texel.
  expect(bytes).toBe(3 * 16 + 8 * 16)
  expect(texels).toBe(16 + 8 + 16 + 16)
})

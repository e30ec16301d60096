import { expose } from 'comlink'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { LayerStroke } from '../../../../studio/src/document/document.ts'
import { Drawing } from '../../../../studio/src/draw/drawing.ts'
import { sampleDocument } from '../sample-document.ts'

const prepared: unknown[] = []
const SETTINGS = { base: null, hasOnset: false }

/** Fake worker. It records its preparation requests, and draws nothing. */
function FakeWorker() {
  const { port1, port2 } = new MessageChannel()
  const service = {
    begin() {},
    addLayer() {},
    draw: () => [],
    prepare: (stroke: unknown) => void prepared.push(stroke),
  }
  expose(service, port2)
  return Object.assign(port1, { terminate: () => port1.close() })
}

describe('the worker that draws strokes', () => {
  const mesh = { positions: [], uvs: [], indices: [] }
  let drawing: Drawing

  beforeEach(async () => {
    vi.stubGlobal('Worker', FakeWorker)
    prepared.length = 0
    drawing = new Drawing()
    await drawing.begin({ mesh, size: 4, scale: 1000, frame: 'orthonormal' })
  })
  afterEach(() => {
    drawing.dispose()
    vi.unstubAllGlobals()
  })

  it('is asked to prepare for the selected stroke, by its index in the layer, or for no stroke', async () => {
    const stroke = sampleDocument().strokes[0]
    const others = [{ ...stroke }, stroke]
    await drawing.draw(stroke.layer, others, SETTINGS)
    await drawing.prepare(stroke)
    await drawing.prepare(null)
    expect(prepared).toEqual([{ layer: stroke.layer, index: 1 }, null])
  })

  it('gets no request for a stroke that it has not drawn, and keeps its preparation', async () => {
    const stroke: LayerStroke = sampleDocument().strokes[0]
    await drawing.prepare(stroke)
    await drawing.draw(stroke.layer, [stroke], SETTINGS)
    await drawing.prepare({ ...stroke })
    expect(prepared).toEqual([])
  })
})

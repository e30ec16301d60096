import { signal } from '@preact/signals'
import { PerspectiveCamera } from 'three'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { imageOf } from '../../../studio/src/document/sculpted.ts'
import { AreaEditor } from '../../../studio/src/session/area-editor.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { Sculpting, type SculptingParts } from '../../../studio/src/tools/sculpting.ts'
import { pickerOf, plainSheet } from './paint/skins.ts'
import { attempts, frozen, sampleDocument, weightsOf } from './sample-document.ts'
import { ToolHand } from './tool-hand.ts'

vi.mock(import('../../../studio/src/tools/brush-ring.ts'), async (original) => ({
  ...(await original()),
  BrushRing: class {
    update() {}
  } as never,
}))

const { skin, picker } = pickerOf(plainSheet())

let host: ToolHand
let session: Session
let areas: AreaEditor
let sculpting: Sculpting
/** Activations of the areas on the face. */
let activations: Map<string, number>
let errors: string[]

beforeEach(() => {
  vi.stubGlobal('addEventListener', () => {})
  host = new ToolHand()
  session = new Session()
  const { attempt, ...others } = attempts()
  errors = others.errors
  areas = new AreaEditor(session, attempt)
  const [forehead] = sampleDocument().areas
  const weights = weightsOf(0)
  weights.data.fill(255, 0, 8)
  const layers = sampleDocument().layers.map(({ sculpted: _, ...layer }) => layer)
  session.open(frozen({ ...sampleDocument(), layers, drivers: [], areas: [{ ...forehead, weights }] }))
  activations = new Map([['forehead', 0]])
  const dials = [...activations.keys()].map((name) => ({
    name,
    read: () => activations.get(name)!,
    write: (value: number) => activations.set(name, value),
  }))
  const viewer = { areas: dials, stage: { camera: new PerspectiveCamera() }, driven: { drive() {} } }
  viewer.stage.camera.position.set(0, 0, 5)
  sculpting = new Sculpting({
    session,
    areas,
    viewer: signal(viewer),
    face: { open: {}, at: () => ({ skin, picker, texture: picker }), preparation: () => null },
    host,
    stage: {},
    wake: () => {},
    attempt,
  } as unknown as SculptingParts)
  sculpting.isOn.value = true
})

afterEach(() => {
  vi.unstubAllGlobals()
  expect(errors).toEqual([])
})

const drag = (...ys: number[]) => host.drag(() => sculpting.advance(), ...ys)
const release = () => host.release()
const document = () => session.document.value!
/** Returns the greatest sculpted height of a layer. @param i index of the layer, default: the last one. */
const highest = ({ layers }: StudioDocument, i = layers.length - 1) =>
  layers[i].sculpted ? Math.max(...imageOf(layers[i].sculpted).data) : 0

describe('the tool that sculpts', () => {
  it('changes the document in each frame, in one undo step', () => {
    const before = document()
    drag(0.02, 0.03)
    expect(highest(document())).toBeGreaterThan(300)
    release()
    expect(session.undoLabel.value).toBe('Sculpt')
    const after = document()
    drag(0.03, 0.02)
    release()
    session.undo()
    expect(document()).toBe(after)
    session.undo()
    expect(document()).toBe(before)
  })

  it('takes a cancelled stroke back, and leaves a document that undo has replaced alone', () => {
    const before = document()
    drag(0.02, 0.03)
    host.cancel()
    expect(document()).toBe(before)
    drag(0.02, 0.03)
    release()
    drag(0.01)
    session.undo()
    expect(host.isHeld).toBe(false)
    expect(session.undoLabel.value).toBe('Sculpt')
  })

  it('shows the chosen area fully while it is on, and restores its activation', () => {
    areas.choose('forehead')
    drag(0.02)
    release()
    expect(activations.get('forehead')).toBe(1)
    expect(areas.added.value).toEqual([])
    sculpting.isOn.value = false
    expect(activations.get('forehead')).toBe(0)
  })

  it('adds an area that is always visible if none is chosen, and asks once when it shows', () => {
    drag(-0.03)
    release()
    const [, added] = document().areas
    expect([added.name, added.layer, added.activation]).toEqual(['sculpted', 'sculpted', 1])
    expect(areas.added.value).toEqual(['sculpted'])
    drag(-0.02)
    release()
    expect(document().areas.length).toBe(2)
    session.undo()
    session.undo()
    expect(areas.added.value).toEqual([])
  })

  it('sculpts the layer of the chosen area', () => {
    areas.addEmpty()
    areas.set('area', { layer: 'down' })
    drag(-0.03)
    release()
    expect([highest(document(), 0), highest(document(), 1) > 100]).toEqual([0, true])
    expect(
      document()
        .areas.at(-1)!
        .weights.data.some((weight) => weight === 255),
    ).toBe(true)
  })
})

import { signal } from '@preact/signals'
import { texelAt } from 'furrow/internal'
import { PerspectiveCamera } from 'three'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { AreaEditor } from '../../../studio/src/session/area-editor.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { Painting, type PaintingParts } from '../../../studio/src/tools/painting.ts'
import { pickerOf, plainSheet } from './paint/skins.ts'
import { attempts, frozen, sampleDocument, weightsOf } from './sample-document.ts'
import { ToolHand } from './tool-hand.ts'

vi.mock(import('../../../studio/src/tools/brush-ring.ts'), async (original) => ({
  ...(await original()),
  BrushRing: class {
    update() {}
  } as never,
}))
vi.mock(import('../../../studio/src/tools/polygon-outline.ts'), async (original) => ({
  ...(await original()),
  PolygonOutline: class {
    show() {}
  } as never,
}))

const { skin, picker } = pickerOf(plainSheet())

let hand: ToolHand
let session: Session
let areas: AreaEditor
let painting: Painting
let filled: string[]
let errors: string[]

beforeEach(() => {
  vi.stubGlobal('addEventListener', () => {})
  hand = new ToolHand()
  session = new Session()
  filled = []
  const { attempt, ...others } = attempts()
  errors = others.errors
  areas = new AreaEditor(session, attempt)
  // The area covers the upper half of the sheet.
  const weights = weightsOf(0)
  weights.data.fill(255, 0, weights.data.length / 2)
  const [forehead] = sampleDocument().areas
  session.open(frozen({ ...sampleDocument(), drivers: [], areas: [{ ...forehead, weights }] }))
  const viewer = { wrinkles: null, stage: { camera: new PerspectiveCamera() } }
  viewer.stage.camera.position.set(0, 0, 5)
  painting = new Painting({
    session,
    areas,
    viewer: signal(viewer),
    face: {
      open: { areaSize: weights.width },
      at: () => ({ skin, picker, texture: picker }),
      preparation: () => null,
    },
    host: hand,
    stage: {},
    wake: () => {},
    onPainted: (area: string) => filled.push(area),
    attempt,
  } as unknown as PaintingParts)
  painting.isOn.value = true
})

afterEach(() => {
  vi.unstubAllGlobals()
  expect(errors).toEqual([])
})

const drag = (...ys: number[]) => hand.drag(() => painting.advance(), ...ys)
const document = () => session.document.value!
const names = () => document().areas.map(({ name }) => name)
/** Returns the weight of an area at a height on the sheet, metres. */
const weightAt = (i: number, y: number) => texelAt(document().areas[i].weights, [0.5, 0.5 - y / 0.1])

describe('painting without a chosen area', () => {
  it('changes the area under the start of the stroke, and chooses it', () => {
    painting.brush.value = { ...painting.brush.value, mode: 'remove' }
    drag(0.03, -0.03)
    hand.release()
    expect(names()).toEqual(['forehead'])
    expect(weightAt(0, 0.03)).toBeLessThan(150)
    expect(areas.chosen.value?.name).toBe('forehead')
    expect(areas.added.value).toEqual([])
  })

  it('adds an area on bare skin that is always visible, in one step, and asks when it shows', () => {
    const before = document()
    drag(-0.03)
    expect(names()).toEqual(['forehead', 'painted'])
    painting.advance()
    hand.release()
    expect(hand.isHeld).toBe(false)
    expect(weightAt(1, -0.03)).toBeGreaterThan(60)
    expect(weightAt(1, 0.03)).toBe(0)
    expect(document().areas[1].activation).toBe(1)
    expect([areas.chosen.value?.name, areas.added.value, filled]).toEqual([
      'painted',
      ['painted'],
      ['painted'],
    ])
    session.undo()
    expect(document()).toBe(before)
    expect(areas.added.value).toEqual([])
  })

  it('keeps painting the added area', () => {
    drag(-0.03)
    hand.release()
    drag(-0.01)
    hand.release()
    expect(names()).toEqual(['forehead', 'painted'])
    const after = weightAt(1, -0.01)
    session.undo()
    expect(weightAt(1, -0.03)).toBeGreaterThan(60)
    expect(weightAt(1, -0.01)).toBeLessThan(after - 60)
  })

  it('takes a cancelled stroke on bare skin back', () => {
    const before = document()
    drag(-0.03, -0.02)
    hand.cancel()
    expect(document()).toBe(before)
  })

  it('adds nothing with a brush that removes', () => {
    painting.brush.value = { ...painting.brush.value, mode: 'remove' }
    drag(-0.03)
    hand.release()
    expect(names()).toEqual(['forehead'])
    expect(session.undoLabel.value).toBeUndefined()
  })

  it('uncovers the area until the next stroke', () => {
    painting.brush.value = { ...painting.brush.value, mode: 'remove' }
    areas.choose('forehead')
    expect(painting.highlighted.value).toBe('forehead')
    painting.uncover()
    hand.hover(0.02)
    expect(painting.highlighted.value).toBeNull()
    drag(0.02)
    expect(painting.highlighted.value).toBe('forehead')
  })
})

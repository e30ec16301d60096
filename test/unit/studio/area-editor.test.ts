import { effect } from '@preact/signals'
import { beforeEach, describe, expect, it } from 'vitest'
import { AreaEditor } from '../../../studio/src/session/area-editor.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { attempts, frozen, sampleDocument, weightsOf } from './sample-document.ts'

let session: Session
let areas: AreaEditor
let errors: string[]

beforeEach(() => {
  session = new Session()
  const tried = attempts()
  errors = tried.errors
  areas = new AreaEditor(session, tried.attempt)
  session.open(frozen(sampleDocument()))
})

const names = () => session.document.value!.areas.map(({ name }) => name)
const chosen = () => areas.chosen.value?.name

describe('the selected area', () => {
  it('stays selected when renamed, and a new area is selected', () => {
    areas.choose('frown')
    const seen: unknown[] = []
    const stop = effect(() => void seen.push(areas.chosen.value?.name))
    areas.rename('frown', 'glabella')
    stop()
    expect(seen).toEqual(['frown', 'glabella'])
    areas.duplicate('glabella')
    expect(chosen()).toBe('glabella 2')
    areas.addEmpty()
    expect(chosen()).toBe('area')
    areas.add({ name: 'nose', weights: { width: 1, height: 1, data: Uint8Array.of(7) } })
    expect(chosen()).toBe('nose')
    expect(areas.chosen.value!.weights).toEqual(weightsOf(7))
  })

  it('is deselected when it is removed, and selected again by undo', () => {
    areas.choose('frown')
    areas.remove('frown')
    expect(chosen()).toBeUndefined()
    session.undo()
    expect(chosen()).toBe('frown')
  })

  it('keeps its name if the new name is refused', () => {
    areas.choose('frown')
    areas.rename('frown', 'cheeks')
    expect(chosen()).toBe('frown')
    expect(errors).toEqual([expect.stringContaining('another area already has this name')])
  })

  it('is deselected when another project is opened', () => {
    areas.choose('frown')
    areas.toggleMute('frown')
    session.open(null)
    session.open(sampleDocument())
    expect(chosen()).toBeUndefined()
    expect(areas.hidden.value).toEqual([])
  })
})

it('reads imported images by the convention that the check box sets', () => {
  expect(areas.convention).toBe('paper')
  areas.isPaper.value = false
  expect(areas.convention).toBe('weight')
})

describe('areas hidden on the stage', () => {
  it('are the muted areas, and all areas except soloed ones if any is soloed', () => {
    areas.toggleMute('frown')
    expect(areas.hidden.value).toEqual(['frown'])
    areas.toggleSolo('cheeks')
    expect(areas.hidden.value).toEqual(names().filter((name) => name !== 'cheeks'))
    areas.toggleSolo('cheeks')
    areas.toggleMute('frown')
    expect(areas.hidden.value).toEqual([])
  })

  it('stay hidden when renamed, and the document does not change', () => {
    const before = session.document.value
    areas.toggleMute('frown')
    expect(session.document.value).toBe(before)
    areas.rename('frown', 'glabella')
    expect(areas.hidden.value).toEqual(['glabella'])
  })

  it('stay the same array while other parts of the document change, so that the face is not redrawn', () => {
    areas.toggleMute('frown')
    const before = areas.hidden.value
    session.edit('Remove lines', (document) => ({ ...document, strokes: [] }))
    areas.set('frown', { activation: 0.7 })
    expect(areas.hidden.value).toBe(before)
  })

  it('are none once the only soloed area is removed', () => {
    areas.toggleSolo('frown')
    areas.remove('frown')
    expect(areas.hidden.value).toEqual([])
  })
})

it('moving a slider until its release is one undo step', () => {
  for (const activation of [0.2, 0.4]) areas.set('frown', { activation })
  areas.settle()
  areas.set('frown', { activation: 0.6 })
  const activation = () => session.document.value!.areas.find(({ name }) => name === 'frown')!.activation
  session.undo()
  expect(activation()).toBe(0.4)
  session.undo()
  expect(activation()).toBe(sampleDocument().areas.find(({ name }) => name === 'frown')!.activation)
})

it('shows areas in a pose in one undo step, and at rest no longer', () => {
  areas.set('frown', { activation: 1 })
  areas.settle()
  const before = session.document.value
  areas.showInPose(['frown'], new Map([['browDownLeft', 0.5]]))
  const { areas: list, drivers } = session.document.value!
  expect(list.find(({ name }) => name === 'frown')!.activation).toBe(0)
  const driver = { type: 'morph', area: 'frown', targets: [{ name: 'browDownLeft', weight: 2 }] }
  expect(drivers).toContainEqual(expect.objectContaining(driver))
  session.undo()
  expect(session.document.value).toBe(before)
  expect(errors).toEqual([])
})

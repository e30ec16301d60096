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

describe('the chosen area', () => {
  it('stays chosen under another name, and what is new is chosen', () => {
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

  it('is none once it is removed, and again the same after undo', () => {
    areas.choose('frown')
    areas.remove('frown')
    expect(chosen()).toBeUndefined()
    session.undo()
    expect(chosen()).toBe('frown')
  })

  it('keeps its name where the new one is refused', () => {
    areas.choose('frown')
    areas.rename('frown', 'cheeks')
    expect(chosen()).toBe('frown')
    expect(errors).toEqual([expect.stringContaining('two of the areas would have one name')])
  })

  it('is none on another face', () => {
    areas.choose('frown')
    areas.toggleMute('frown')
    session.open(null)
    session.open(sampleDocument())
    expect(chosen()).toBeUndefined()
    expect(areas.hidden.value).toEqual([])
  })
})

describe('what the stage leaves out', () => {
  it('are muted areas, and all but the soloed ones', () => {
    areas.toggleMute('frown')
    expect(areas.hidden.value).toEqual(['frown'])
    areas.toggleSolo('cheeks')
    expect(areas.hidden.value).toEqual(names().filter((name) => name !== 'cheeks'))
    areas.toggleSolo('cheeks')
    areas.toggleMute('frown')
    expect(areas.hidden.value).toEqual([])
  })

  it('is muted under another name too, and the document is left alone', () => {
    const before = session.document.value
    areas.toggleMute('frown')
    expect(session.document.value).toBe(before)
    areas.rename('frown', 'glabella')
    expect(areas.hidden.value).toEqual(['glabella'])
  })

  it('stays the same list while the document changes elsewhere: the face need not be drawn again', () => {
    areas.toggleMute('frown')
    const before = areas.hidden.value
    session.edit('Remove lines', (document) => ({ ...document, strokes: [] }))
    areas.set('frown', { activation: 0.7 })
    expect(areas.hidden.value).toBe(before)
  })

  it('is nothing once the only soloed area is removed', () => {
    areas.toggleSolo('frown')
    areas.remove('frown')
    expect(areas.hidden.value).toEqual([])
  })
})

it('a slider that moves is one step of undo, until it is let go', () => {
  for (const activation of [0.2, 0.4]) areas.set('frown', { activation })
  areas.settle()
  areas.set('frown', { activation: 0.6 })
  const activation = () => session.document.value!.areas.find(({ name }) => name === 'frown')!.activation
  session.undo()
  expect(activation()).toBe(0.4)
  session.undo()
  expect(activation()).toBe(sampleDocument().areas.find(({ name }) => name === 'frown')!.activation)
})

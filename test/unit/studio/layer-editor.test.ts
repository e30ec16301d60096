import { beforeEach, expect, it } from 'vitest'
import { LayerEditor } from '../../../studio/src/session/layer-editor.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { attempts, frozen, sampleDocument } from './sample-document.ts'

let session: Session
let layers: LayerEditor
let errors: string[]

beforeEach(() => {
  session = new Session()
  const tried = attempts()
  errors = tried.errors
  layers = new LayerEditor({ session, work: async () => null, avatar: () => null, attempt: tried.attempt })
  session.open(frozen(sampleDocument()))
})

const names = () => session.document.value!.layers.map(({ name }) => name)
const named = (name: string) => session.document.value!.layers.find((layer) => layer.name === name)!

it('adds layers with new names and moves them, but not past either end', () => {
  layers.add()
  layers.add()
  expect(names()).toEqual(['up', 'down', 'layer', 'layer 2'])
  layers.move('down', -1)
  expect(names()).toEqual(['down', 'up', 'layer', 'layer 2'])
  const before = session.document.value
  layers.move('down', -1)
  layers.move('layer 2', 1)
  expect(session.document.value).toBe(before)
  for (let i = 0; i < 3; i++) session.undo()
  expect(names()).toEqual(['up', 'down'])
})

it('moving a slider is one step, with a label', () => {
  for (const normalScale of [1.2, 1.4, 1.6]) layers.set('up', { normalScale })
  layers.settle()
  layers.set('up', { normalScale: 0.5 })
  expect(session.undoLabel.value).toBe('Change up')
  session.undo()
  expect(named('up').normalScale).toBe(1.6)
  session.undo()
  expect(named('up').normalScale).toBe(1)
})

it('a map can be removed, and undo restores it', () => {
  const { normal } = named('up').maps
  layers.removeMap('up', 'normal')
  expect(named('up').maps).toEqual({})
  session.undo()
  expect(named('up').maps.normal).toBe(normal)
})

it('explains why a layer cannot be removed or renamed, and keeps the document', () => {
  layers.remove('up')
  layers.rename('up', 'down')
  expect(errors).toEqual([
    expect.stringContaining('areas show the layer up'),
    expect.stringContaining('another layer already has this name'),
  ])
  expect(names()).toEqual(['up', 'down'])
})

import { signal } from '@preact/signals'
import { describe, expect, it } from 'vitest'
import { remake } from '../../../studio/src/document/automatic.ts'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { hasOutdatedWrinkles } from '../../../studio/src/document/shapes.ts'
import { parseStudioFile } from '../../../studio/src/keep/studio-file.ts'
import type { SkinSource } from '../../../studio/src/open/skin-source.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { ShapeEditor } from '../../../studio/src/session/shape-editor.ts'
import { frozen, sampleDocument } from './sample-document.ts'

const NAMES = ['key_1', 'key_2', 'browInnerUp_L', 'browInnerUp_R']

const source: SkinSource = {
  skin: {
    positions: [],
    uvs: [],
    indices: [],
    targets: NAMES.map((name) => ({ name, offsets: [] })),
  },
  surface: { kind: 'skin', cloth: 'shirt' },
  limbs: [],
  meshes: ['Head', 'node of the head'],
  frame: 'derivative',
}

function open(shapes: StudioDocument['shapes']) {
  const { shapes: _, ...document } = sampleDocument()
  const session = new Session()
  session.open(frozen({ ...document, ...(shapes && { shapes }) }))
  const editor = new ShapeEditor(session, signal<SkinSource | null>(source))
  return {
    session,
    editor,
    shapes: () => session.document.peek()!.shapes,
    corrections: () => editor.skin.peek()!.targets.map(({ correction }) => correction),
  }
}

describe('a correction of a blendshape', () => {
  it('is stored with the names in the file, and is one undo step', () => {
    const { session, editor, shapes, corrections } = open(undefined)
    editor.correct('key_2', 'browDown')
    expect(shapes()).toEqual([{ mesh: 'Head', target: 'key_2', shape: 'browDown' }])
    expect(corrections()).toEqual([undefined, 'browDown', undefined, undefined])
    expect(session.undoLabel.value).toBe('Correct key_2')
    session.undo()
    expect(shapes()).toBeUndefined()
    expect(corrections()).toEqual([undefined, undefined, undefined, undefined])
  })

  it('replaces a previous correction, also one with another name of the mesh', () => {
    const { editor, shapes, corrections } = open([
      { mesh: 'Other', target: 'key_1', shape: 'jawOpen' },
      { mesh: 'node of the head', target: 'key_1', shape: 'mouthClose' },
    ])
    editor.correct('key_1', 'cheekPuff')
    editor.correct('key_1', null)
    expect(shapes()).toContainEqual({ mesh: 'Head', target: 'key_1' })
    expect(shapes()).toContainEqual({ mesh: 'Other', target: 'key_1', shape: 'jawOpen' })
    expect(corrections()[0]).toBeNull()
  })

  it('is removed when the blendshape is automatic again, also one with another name of the mesh', () => {
    const other = { mesh: 'Other', target: 'key_1', shape: 'jawOpen' }
    const { editor, shapes, corrections } = open([other, { target: 'browInnerUp', shape: 'browDown' }])
    expect(corrections().slice(2)).toEqual(['browDown', 'browDown'])
    editor.correct('browInnerUp_L', undefined)
    expect(corrections()).toEqual([undefined, undefined, undefined, undefined])
    expect(shapes()).toEqual([other])
  })

  it('is one step, however often the same blendshape is changed before `settle` is called', () => {
    const { session, editor, corrections } = open(undefined)
    editor.correct('key_1', 'browDown')
    editor.correct('key_1', 'browDownLeft')
    editor.settle()
    editor.correct('key_1', 'browDownRight')
    session.undo()
    expect(corrections()[0]).toBe('browDownLeft')
    session.undo()
    expect(corrections()[0]).toBeUndefined()
  })
})

describe('automatic wrinkles', () => {
  const shapes = [{ mesh: 'Head', target: 'key_1', shape: 'jawOpen' }]
  const auto = { strength: 1, size: 64, seed: 1 }

  it.each([
    [undefined, undefined, false],
    [shapes, shapes.map((shape) => ({ ...shape })), false],
    [shapes, undefined, true],
    [undefined, shapes, true],
    [shapes, [{ mesh: 'Head', target: 'key_1' }], true],
  ])('with corrections %j that were made with %j are outdated: %s', (present, made, isOutdated) => {
    expect(hasOutdatedWrinkles({ shapes: present, auto: { ...auto, shapes: made } })).toBe(isOutdated)
  })

  it('are not outdated if there are none', () => {
    expect(hasOutdatedWrinkles({ shapes })).toBe(false)
  })

  it('are made again without losing corrections', () => {
    const { shapes: _, ...made } = sampleDocument()
    expect(remake({ ...sampleDocument(), shapes }, made).shapes).toBe(shapes)
  })
})

describe('studio.json', () => {
  it.each([
    ['a number instead of a list', 5],
    ['a shape that ARKit does not have', [{ target: 'key_1', shape: 'browUpward' }]],
  ])('with corrections that are %s is read without the corrections of its wrinkles', (_, shapes) => {
    const { studio, note } = parseStudioFile({
      version: 1,
      scale: 10,
      auto: { strength: 1, size: 64, seed: 1, shapes },
    })
    expect(studio).toEqual({ version: 1, scale: 10 })
    expect(note).toContain('auto')
  })
})

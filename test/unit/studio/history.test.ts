import { describe, expect, it } from 'vitest'
import { addEmptyArea, paintArea, setArea } from '../../../studio/src/document/areas.ts'
import { History } from '../../../studio/src/document/history.ts'
import { addStroke } from '../../../studio/src/document/strokes.ts'
import { frozen, sampleDocument, strokeOf } from './sample-document.ts'

const start = frozen(sampleDocument())
const withActivation = (activation: number) => setArea(start, 'frown', { activation })

function undoSteps(history: History): number {
  let steps = 0
  for (; history.undoLabel !== undefined; steps++) history.undo()
  return steps
}

describe('the history', () => {
  it('returns exactly the previous documents on undo, and the later ones on redo', () => {
    const history = new History(start)
    const [one, two] = [withActivation(0.1), withActivation(0.2)]
    history.push('one', one)
    history.push('two', two)
    expect([history.undoLabel, history.redoLabel]).toEqual(['two', undefined])
    history.undo()
    expect(history.document).toBe(one)
    expect([history.undoLabel, history.redoLabel]).toEqual(['one', 'two'])
    history.undo()
    history.undo()
    expect(history.document).toBe(start)
    history.redo()
    history.redo()
    history.redo()
    expect(history.document).toBe(two)
    expect([history.undoLabel, history.redoLabel]).toEqual(['two', undefined])
  })

  it('drops undone steps after another change', () => {
    const history = new History(start)
    history.push('one', withActivation(0.1))
    history.undo()
    history.push('two', withActivation(0.2))
    expect(history.redoLabel).toBeUndefined()
    history.undo()
    expect(history.document).toBe(start)
  })

  it('ignores a step that changes nothing, and keeps redo steps', () => {
    const history = new History(start)
    history.push('one', withActivation(0.1))
    history.undo()
    history.push('nothing', start)
    expect([history.undoLabel, history.redoLabel]).toEqual([undefined, 'one'])
  })

  it('merges steps with the same key until `settle` is called', () => {
    const history = new History(start)
    history.push('drag', withActivation(0.1), 'slider')
    history.push('drag further', withActivation(0.2), 'slider')
    expect(history.undoLabel).toBe('drag')
    history.settle()
    history.push('drag again', withActivation(0.3), 'slider')
    history.undo()
    expect(history.document).toEqual(withActivation(0.2))
    history.undo()
    expect(history.document).toBe(start)
    history.redo()
    expect(history.document).toEqual(withActivation(0.2))
  })

  it('does not merge steps with different keys or without a key', () => {
    const history = new History(start)
    history.push('a', withActivation(0.1), 'a')
    history.push('b', withActivation(0.2), 'b')
    history.push('c', withActivation(0.3))
    history.push('d', withActivation(0.4))
    expect(undoSteps(history)).toBe(4)
  })

  it('does not merge a step with one from before an undo or redo', () => {
    const history = new History(start)
    history.push('drag', withActivation(0.1), 'slider')
    history.push('other', withActivation(0.2))
    history.undo()
    history.push('drag again', withActivation(0.3), 'slider')
    expect(undoSteps(history)).toBe(2)
    history.redo()
    history.push('drag', withActivation(0.4), 'slider')
    expect(undoSteps(history)).toBe(2)
  })

  it('keeps at most 2000 steps, however small', () => {
    const history = new History(start)
    for (let i = 1; i <= 2100; i++) history.push('nudge', withActivation(i / 3000))
    expect(undoSteps(history)).toBe(2000)
    expect(history.document).toEqual(withActivation(100 / 3000))
  })

  it('keeps 200 steps of any size, and more while they need less than 64 MB', () => {
    // Nothing is written to the arrays, so the operating system gives them no memory.
    const painted = (side: number, steps: number) => {
      const weights = () => ({ width: side, height: side, data: new Uint8Array(side * side) })
      const history = new History(addEmptyArea({ ...start, areas: [], areaSize: side }, 'large'))
      for (let i = 0; i < steps; i++) history.push('paint', paintArea(history.document, 'large', weights()))
      return undoSteps(history)
    }
    expect(painted(1024, 220)).toBe(200)
    expect(painted(512, 300)).toBe(256)
  })

  it('counts only data that is not part of the current document', () => {
    // The current document has 128 MB, which it shares with every step.
    const bytes = new Uint8Array(2 ** 27)
    const layers = [{ ...start.layers[0], maps: { normal: { mimeType: 'image/png', bytes } } }]
    const history = new History({ ...start, layers })
    for (let i = 0; i < 300; i++)
      history.push('draw', addStroke(history.document, strokeOf('up', 'forehead')))
    expect(undoSteps(history)).toBe(300)
  })

  it('keeps a dragged slider as one step, however long it is dragged', () => {
    const history = new History(start)
    for (let i = 0; i < 5000; i++) history.push('drag', withActivation(i / 5000), 'slider')
    expect(undoSteps(history)).toBe(1)
  })
})

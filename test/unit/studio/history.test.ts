import { describe, expect, it } from 'vitest'
import { addEmptyArea, paintArea, setArea } from '../../../studio/src/document/areas.ts'
import { History } from '../../../studio/src/document/history.ts'
import { addStroke } from '../../../studio/src/document/strokes.ts'
import { frozen, sampleDocument, strokeOf } from './sample-document.ts'

const start = frozen(sampleDocument())
const withActivation = (activation: number) => setArea(start, 'frown', { activation })

/** How often undo finds something to undo. */
function undoSteps(history: History): number {
  let steps = 0
  for (; history.undoLabel !== undefined; steps++) history.undo()
  return steps
}

describe('the history', () => {
  it('undoes to the very documents that were, and redoes', () => {
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

  it('forgets what was undone when something else is done', () => {
    const history = new History(start)
    history.push('one', withActivation(0.1))
    history.undo()
    history.push('two', withActivation(0.2))
    expect(history.redoLabel).toBeUndefined()
    history.undo()
    expect(history.document).toBe(start)
  })

  it('ignores a step that changes nothing, and keeps what can be redone', () => {
    const history = new History(start)
    history.push('one', withActivation(0.1))
    history.undo()
    history.push('nothing', start)
    expect([history.undoLabel, history.redoLabel]).toEqual([undefined, 'one'])
  })

  it('merges steps with one key until they settle', () => {
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

  it('keeps steps of different keys or none apart', () => {
    const history = new History(start)
    history.push('a', withActivation(0.1), 'a')
    history.push('b', withActivation(0.2), 'b')
    history.push('c', withActivation(0.3))
    history.push('d', withActivation(0.4))
    expect(undoSteps(history)).toBe(4)
  })

  it('does not merge into a step that was there before an undo or redo', () => {
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

  it('keeps 2000 small steps', () => {
    const history = new History(start)
    for (let i = 1; i <= 2100; i++) history.push('nudge', withActivation(i / 3000))
    expect(undoSteps(history)).toBe(2000)
    expect(history.document).toEqual(withActivation(100 / 3000))
  })

  it('keeps 200 steps however large, and more up to 64 MB', () => {
    // Never written to, so that they cost no memory.
    const painted = (side: number, steps: number) => {
      const weights = () => ({ width: side, height: side, data: new Uint8Array(side * side) })
      const history = new History(addEmptyArea({ ...start, areas: [], areaSize: side }, 'large'))
      for (let i = 0; i < steps; i++) history.push('paint', paintArea(history.document, 'large', weights()))
      return undoSteps(history)
    }
    expect(painted(1024, 220)).toBe(200)
    expect(painted(512, 300)).toBe(256)
  })

  it('counts only what the present document has no longer', () => {
    // 128 MB in the present document, which every step has in common.
    const bytes = new Uint8Array(2 ** 27)
    const layers = [{ ...start.layers[0], maps: { normal: { mimeType: 'image/png', bytes } } }]
    const history = new History({ ...start, layers })
    for (let i = 0; i < 300; i++)
      history.push('draw', addStroke(history.document, strokeOf('up', 'forehead')))
    expect(undoSteps(history)).toBe(300)
  })

  it('counts a dragged slider once, by what its step replaced', () => {
    const history = new History(start)
    for (let i = 0; i < 5000; i++) history.push('drag', withActivation(i / 5000), 'slider')
    expect(undoSteps(history)).toBe(1)
  })
})

import { signal } from '@preact/signals'
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { setArea } from '../../../studio/src/document/areas.ts'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { AutoSave } from '../../../studio/src/keep/autosave.ts'
import { frozen, sampleDocument } from './sample-document.ts'

const start = frozen(sampleDocument())
const changedBy = (activation: number) => setArea(start, 'frown', { activation })

/** Fake document of a page, which the test can hide. */
class Page extends EventTarget {
  visibilityState: DocumentVisibilityState = 'visible'

  hide(): void {
    this.visibilityState = 'hidden'
    this.dispatchEvent(new Event('visibilitychange'))
  }
}

/** Records the saved documents. Each save takes until the test ends it. */
class Saves {
  readonly documents: StudioDocument[] = []
  running = 0
  most = 0
  #end: (error?: Error) => void = () => {}

  readonly save = (document: StudioDocument): Promise<void> => {
    this.documents.push(document)
    this.most = Math.max(this.most, ++this.running)
    return new Promise((resolve, reject) => {
      this.#end = (error) => {
        this.running--
        if (error) reject(error)
        else resolve()
      }
    })
  }

  async end(error?: Error): Promise<void> {
    this.#end(error)
    await vi.advanceTimersByTimeAsync(0)
  }
}

function begin() {
  const document = signal(start)
  const page = new Page()
  const saves = new Saves()
  const autosave = new AutoSave(document, saves.save, page as unknown as Document)
  return { document, page, saves, autosave, kind: () => autosave.state.value.kind }
}

beforeEach(() => {
  vi.useFakeTimers()
})
afterEach(() => {
  vi.useRealTimers()
})

describe('automatic saving', () => {
  it('does nothing without changes', async () => {
    const { saves, page, kind } = begin()
    page.hide()
    await vi.advanceTimersByTimeAsync(60_000)
    expect(saves.documents).toEqual([])
    expect(kind()).toBe('saved')
  })

  it('saves a change immediately, and reports its progress', async () => {
    const { document, saves, kind } = begin()
    document.value = changedBy(0.1)
    expect(kind()).toBe('saving')
    await vi.advanceTimersByTimeAsync(0)
    expect(saves.documents).toEqual([document.value])
    expect(kind()).toBe('saving')
    await saves.end()
    expect(kind()).toBe('saved')
  })

  it('saves at most once a second, and each change within a second', async () => {
    const { document, saves } = begin()
    for (let i = 1; i <= 29; i++) {
      document.value = changedBy(i / 100)
      await vi.advanceTimersByTimeAsync(100)
      if (saves.running > 0) await saves.end()
    }
    expect(saves.documents.length).toBe(3)
    await vi.advanceTimersByTimeAsync(1000)
    expect(saves.documents.at(-1)).toBe(document.value)
  })

  it('never runs two saves at a time, and then saves changes made during a save', async () => {
    const { document, saves, kind } = begin()
    document.value = changedBy(0.1)
    await vi.advanceTimersByTimeAsync(0)
    document.value = changedBy(0.2)
    await vi.advanceTimersByTimeAsync(10_000)
    expect(saves.documents.length).toBe(1)
    await saves.end()
    expect(kind()).toBe('saving')
    await vi.advanceTimersByTimeAsync(0)
    expect(saves.documents.at(-1)).toBe(document.value)
    await saves.end()
    expect([kind(), saves.most]).toEqual(['saved', 1])
  })

  it('saves in the same task when the page is hidden', async () => {
    const { document, saves, page } = begin()
    document.value = changedBy(0.1)
    await vi.advanceTimersByTimeAsync(0)
    await saves.end()
    document.value = changedBy(0.2)
    page.hide()
    expect(saves.documents.at(-1)).toBe(document.value)
  })

  it('saves right after a save in progress when the page is hidden', async () => {
    const { document, saves, page } = begin()
    document.value = changedBy(0.1)
    await vi.advanceTimersByTimeAsync(0)
    document.value = changedBy(0.2)
    page.hide()
    await saves.end()
    expect(saves.documents.at(-1)).toBe(document.value)
    expect(saves.most).toBe(1)
  })

  it('reports why a save failed, and tries again', async () => {
    const { document, saves, autosave, kind } = begin()
    document.value = changedBy(0.1)
    await vi.advanceTimersByTimeAsync(0)
    await saves.end(new DOMException('full', 'QuotaExceededError'))
    expect(autosave.state.value).toMatchObject({
      kind: 'failed',
      reason: { name: 'FurrowError', problem: 'the browser has no room left for this project' },
    })
    document.value = changedBy(0.2)
    expect(kind()).toBe('failed')
    await vi.advanceTimersByTimeAsync(5000)
    expect(saves.documents.at(-1)).toBe(document.value)
    await saves.end()
    expect(kind()).toBe('saved')
  })

  it('has nothing to save after a change that failed to save is undone', async () => {
    const { document, saves, kind } = begin()
    document.value = changedBy(0.1)
    await vi.advanceTimersByTimeAsync(0)
    await saves.end(new Error('no'))
    document.value = start
    expect(kind()).toBe('saved')
    await vi.advanceTimersByTimeAsync(60_000)
    expect(saves.documents.length).toBe(1)
  })

  it('saves unsaved changes right after the save in progress when asked to flush', async () => {
    const { document, saves, autosave } = begin()
    document.value = changedBy(0.1)
    await vi.advanceTimersByTimeAsync(0)
    document.value = changedBy(0.2)
    const flushed = autosave.flush()
    await saves.end()
    await saves.end()
    await flushed
    expect(saves.documents).toEqual([changedBy(0.1), changedBy(0.2)])
    await autosave.flush()
    expect(saves.documents.length).toBe(2)
  })

  it('saves unsaved changes when it is disposed', async () => {
    const { document, saves, autosave, page } = begin()
    document.value = changedBy(0.1)
    const disposed = autosave.dispose()
    expect(saves.documents.length).toBe(1)
    await saves.end()
    await disposed
    document.value = changedBy(0.2)
    page.hide()
    await vi.advanceTimersByTimeAsync(60_000)
    expect(saves.documents.length).toBe(1)
  })

  it('saves its own last document when it is disposed, even if another face is open by then', async () => {
    const { document, saves, autosave } = begin()
    document.value = changedBy(0.25)
    await vi.advanceTimersByTimeAsync(0)
    const last = changedBy(0.5)
    document.value = last
    const disposed = autosave.dispose()
    document.value = changedBy(0.75)
    await saves.end()
    await saves.end()
    await disposed
    expect(saves.documents.at(-1)).toBe(last)
  })
})

import { expect, it, vi } from 'vitest'
import { nextTask, runInTurn } from '../../../studio/src/later.ts'

it('deferred tasks run one at a time, in order, and not after they are cancelled', async () => {
  /** Calls the requested idle callback, like a browser whose page is idle. */
  let rest: (() => void) | null = null
  vi.stubGlobal('requestIdleCallback', (callback: () => void) => {
    rest = callback
  })
  const done: string[] = []
  runInTurn(() => done.push('first'))
  const cancel = runInTurn(() => done.push('second'))
  runInTurn(() => done.push('third'))
  const nextRest = async () => {
    rest?.()
    await nextTask()
  }
  await nextTask()
  expect(done).toEqual([])
  await nextRest()
  expect(done).toEqual(['first'])
  cancel()
  await nextRest()
  await nextRest()
  expect(done).toEqual(['first', 'third'])
  vi.unstubAllGlobals()
})

import { expect, test } from 'vitest'
import { Latest } from '../../../studio/src/session/latest.ts'

/** Returns a task that records its values. Each run takes until the test ends it. */
function slowTask() {
  const begun: number[] = []
  const ends: { end(): void; fail(error: Error): void }[] = []
  const task = (value: number) =>
    new Promise<void>((end, fail) => {
      begun.push(value)
      ends.push({ end, fail })
    })
  return { begun, ends, latest: new Latest(task) }
}

const turn = () => new Promise<void>((resolve) => setTimeout(resolve))

test('of the values that arrive during a run, only the last one is run, after the current run', async () => {
  const { begun, ends, latest } = slowTask()
  for (const value of [1, 2, 3, 4]) void latest.run(value)
  await turn()
  expect(begun).toEqual([1])
  ends[0].end()
  await turn()
  expect(begun).toEqual([1, 4])
  ends[1].end()
  await turn()
  void latest.run(5)
  expect(begun).toEqual([1, 4, 5])
})

test('a waiting value that is dropped is not run', async () => {
  const { begun, ends, latest } = slowTask()
  void latest.run(1)
  void latest.run(2)
  latest.drop()
  ends[0].end()
  await turn()
  expect(begun).toEqual([1])
})

test('a run that fails does not prevent the next one', async () => {
  const { begun, ends, latest } = slowTask()
  const failed = latest.run(1)
  ends[0].fail(new Error('no wrinkles'))
  await expect(failed).rejects.toThrow('no wrinkles')
  void latest.run(2)
  expect(begun).toEqual([1, 2])
})

test('a value that arrives during a failing run gets a run', async () => {
  const { begun, ends, latest } = slowTask()
  const failed = latest.run(1)
  void latest.run(2)
  ends[0].fail(new Error('no wrinkles'))
  await turn()
  expect(begun).toEqual([1, 2])
  ends[1].end()
  await expect(failed).rejects.toThrow('no wrinkles')
})

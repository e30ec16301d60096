import { describe, expect, it } from 'vitest'
import { Preparation } from '../../../../studio/src/draw/preparation.ts'

/** Returns a generator of steps, and counts how many of them run in each task of the event loop. */
function counted(total: number) {
  const tasks: number[] = []
  let task = -1
  const done = { steps: 0 }
  function* steps() {
    for (let i = 0; i < total; i++) {
      done.steps++
      if (task < 0) {
        task = tasks.push(0) - 1
        setTimeout(() => {
          task = -1
        })
      }
      tasks[task]++
      yield
    }
  }
  return { tasks, done, steps: steps() }
}

describe('a preparation', () => {
  it('runs in several tasks of the event loop, so that calls can run in between', async () => {
    const { tasks, steps } = counted(20)
    await new Preparation().run(steps)
    expect(tasks).toEqual([8, 8, 4])
  })

  it('ends when another preparation begins, or when it is replaced by none', async () => {
    const preparation = new Preparation()
    const [first, second] = [counted(20), counted(20)]
    const runs = [preparation.run(first.steps), preparation.run(second.steps)]
    await Promise.all(runs)
    expect(first.done.steps).toBe(8)
    expect(second.done.steps).toBe(20)
    const third = counted(20)
    const run = preparation.run(third.steps)
    await preparation.run(null)
    await run
    expect(third.done.steps).toBe(8)
  })
})

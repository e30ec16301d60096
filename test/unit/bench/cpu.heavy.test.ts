import { execFile } from 'node:child_process'
import { promisify } from 'node:util'
import { expect, it } from 'vitest'

/** Measures in a process of its own, as the benchmark does: what is measured here runs otherwise than in a page. */
const SCRIPT = `
  import { measureCpu } from './bench/cpu.mjs'
  const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1]
  const cases = [[false], [true], [true, false]]
  console.log(JSON.stringify(cases.map(([all, ownClock]) => measureCpu(median, all, ownClock))))
`

it('drivers allocate nothing per frame, but for the number that the usual clock returns', async () => {
  const words = ['--input-type=module', '-e', SCRIPT]
  const { stdout, stderr } = await promisify(execFile)(process.execPath, words)
  const [blendshapes, every, withClock] = JSON.parse(stdout)
  expect(stderr).toBe('')
  expect(blendshapes).toMatchObject({ targets: 57, areas: 64 })
  expect(blendshapes.bytes).toBeLessThan(4)
  expect(every.bytes).toBeLessThan(4)
  expect(withClock.bytes).toBeLessThan(20)
})

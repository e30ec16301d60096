import { execFile } from 'node:child_process'
import { promisify } from 'node:util'
import { DRIVER_TYPES } from 'furrow/internal'
import { expect, it } from 'vitest'

/** Script for a separate process, as in the benchmark: the process of a test compiles and optimises code differently. */
const SCRIPT = `
  import { measureCpu, OTHER_DRIVERS } from './bench/cpu.mjs'
  const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1]
  const cases = [[false], [true], [true, false]]
  const measured = cases.map(([allTypes, ownClock]) => measureCpu(allTypes, ownClock))
  console.log(JSON.stringify({ measured, types: Object.keys(OTHER_DRIVERS) }))
`

// Retries, because a busy machine may optimise the code late. Code that allocates in each frame fails every time.
it('drivers allocate nothing per frame, except for the number that the default clock returns', {
  retry: 2,
}, async () => {
  const args = ['--input-type=module', '-e', SCRIPT]
  const { stdout, stderr } = await promisify(execFile)(process.execPath, args)
  const { measured, types } = JSON.parse(stdout)
  const [blendshapes, allTypes, defaultClock] = measured
  expect(stderr).toBe('')
  expect(['morph', ...types].sort()).toEqual([...DRIVER_TYPES].sort())
  expect(blendshapes).toMatchObject({ targets: 57, areas: 64 })
  expect(blendshapes.bytes).toBeLessThan(4)
  expect(allTypes.bytes).toBeLessThan(4)
  expect(defaultClock.bytes).toBeLessThan(20)
})

import { afterAll, beforeAll, describe } from 'vitest'
import { createHarness, type Harness, RENDERERS } from '../harness.ts'
import { testSamples } from './suite.ts'
import { ThreeRunner } from './three-runner.ts'

describe.each(RENDERERS)('conformance of three.js on %s', (name) => {
  let harness: Harness
  let runner: ThreeRunner
  beforeAll(async () => {
    harness = await createHarness(name)
    runner = new ThreeRunner(harness)
  })
  afterAll(() => {
    runner.dispose()
    harness.dispose()
  })

  testSamples((sample) => runner.open(sample))
})

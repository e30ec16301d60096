import { afterAll, beforeAll, describe } from 'vitest'
import { harnessOn, RENDERERS } from '../harness.ts'
import { testSamples } from './suite.ts'
import { ThreeRunner } from './three-runner.ts'

describe.each(RENDERERS)('conformance of three.js on %s', (name) => {
  const harness = harnessOn(name)
  let runner: ThreeRunner
  beforeAll(() => {
    runner = new ThreeRunner(harness)
  })
  afterAll(() => {
    runner.dispose()
  })

  testSamples((sample) => runner.open(sample))
})

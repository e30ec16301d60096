import { afterEach, describe, expect } from 'vitest'
import { ENGINES, harnessOn } from '../babylon/harness.ts'
import { openSample } from './babylon-runner.ts'
import { testSamples } from './suite.ts'

describe.each(ENGINES)('conformance of Babylon.js on %s', (name) => {
  const harness = harnessOn(name)
  afterEach(() => expect(harness.errors).toEqual([]))

  testSamples((sample) => openSample(harness, sample))
})

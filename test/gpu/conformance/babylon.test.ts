import { afterAll, afterEach, beforeAll, describe, expect } from 'vitest'
import { type BabylonHarness, createHarness, ENGINES } from '../babylon/harness.ts'
import { openSample } from './babylon-runner.ts'
import { testSamples } from './suite.ts'

describe.each(ENGINES)('conformance of Babylon.js on %s', (name) => {
  let harness: BabylonHarness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterEach(() => expect(harness.errors).toEqual([]))
  afterAll(() => harness.dispose())

  testSamples((sample) => openSample(harness, sample))
})

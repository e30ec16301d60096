import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { createHarness, type Harness, RENDERERS } from './harness.ts'
import { compareWrinkles, loadPacked } from './packed.ts'

declare const __REAL_FACE__: string

describe.each(RENDERERS)('a face compressed by glTF-Transform, on %s', (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())

  // Lost or displaced wrinkles would not correlate; halved ones would have half the strength.
  it.each([
    ['dedup, prune, resize, lossless WebP and meshopt', 'transformed', 0.98, 0.05],
    ['dedup, prune, resize, lossy WebP and meshopt', 'transformed-lossy', 0.9, 0.2],
    ['draco', 'draco', 0.95, 0.1],
    ['quantize', 'quantized', 0.95, 0.1],
  ])('still wrinkles after %s', async (_, file, minCorrelation, tolerance) => {
    const [shipped, transformed] = [await loadPacked(harness, 'shipped'), await loadPacked(harness, file)]
    const { strength, correlation, ratio } = await compareWrinkles(harness, shipped, transformed)
    expect(strength).toBeGreaterThan(1)
    expect(correlation).toBeGreaterThan(minCorrelation)
    expect(Math.abs(ratio - 1)).toBeLessThan(tolerance)
    for (const { userData } of [shipped, transformed]) userData.wrinkles[0].dispose()
  })

  it.skipIf(!__REAL_FACE__)('still wrinkles if it is a scan', async () => {
    const [scan, transformed] = [
      await loadPacked(harness, 'scan'),
      await loadPacked(harness, 'scan-transformed'),
    ]
    const { strength, correlation, ratio } = await compareWrinkles(harness, scan, transformed)
    expect(strength).toBeGreaterThan(1)
    expect(correlation).toBeGreaterThan(0.95)
    expect(Math.abs(ratio - 1)).toBeLessThan(0.1)
    for (const { userData } of [scan, transformed]) userData.wrinkles[0].dispose()
  })
})

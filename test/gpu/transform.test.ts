import { beforeAll, describe, expect, it } from 'vitest'
import { BARE_FACES } from './bare-faces.ts'
import { harnessOn, RENDERERS } from './harness.ts'
import { compareWrinkles, loadPacked, wrinklesAlone } from './packed.ts'

describe.each(RENDERERS)('a face compressed by glTF-Transform, on %s', (name) => {
  const harness = harnessOn(name)
  let shipped: Float32Array
  beforeAll(async () => {
    shipped = await wrinklesOf('shipped')
  })

  async function wrinklesOf(file: string): Promise<Float32Array> {
    const gltf = await loadPacked(harness, file)
    const wrinkles = await wrinklesAlone(harness, gltf)
    gltf.userData.wrinkles[0].dispose()
    return wrinkles
  }

  // Lost or moved wrinkles have a correlation below `least`. Halved wrinkles change the strength by more than `most`.
  it.each([
    ['dedup, prune, resize, lossless WebP and meshopt', 'transformed', 0.98, 0.05],
    ['dedup, prune, resize, lossy WebP and meshopt', 'transformed-lossy', 0.9, 0.2],
    ['draco', 'draco', 0.95, 0.1],
    ['quantize', 'quantized', 0.95, 0.1],
  ])('still wrinkles after %s', async (_, file, least, most) => {
    const { strength, correlation, ratio } = compareWrinkles(shipped, await wrinklesOf(file))
    expect(strength).toBeGreaterThan(1)
    expect(correlation).toBeGreaterThan(least)
    expect(Math.abs(ratio - 1)).toBeLessThan(most)
  })

  it.each(BARE_FACES.map(({ name }, i) => [name, i] as const))(
    'still has the wrinkles that were drawn on %s',
    async (_, i) => {
      const drawn = await wrinklesOf(`drawn-${i}`)
      const { strength, correlation, ratio } = compareWrinkles(
        drawn,
        await wrinklesOf(`drawn-${i}-transformed`),
      )
      expect(strength).toBeGreaterThan(1)
      expect(correlation).toBeGreaterThan(0.95)
      expect(Math.abs(ratio - 1)).toBeLessThan(0.1)
    },
  )
})

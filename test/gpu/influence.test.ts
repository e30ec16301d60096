import type { WrinkleSet } from 'furrow'
import { MeshStandardMaterial } from 'three'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { STEP } from './difference.ts'
import { casesOn, createHarness, type Harness, RENDERERS, square } from './harness.ts'
import { influenceError } from './influence-error.ts'

describe.each(RENDERERS)('influence on %s', (name) => {
  const cases = casesOn(name)
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
    console.info(`${name}: ${harness.adapter}`)
  })
  afterAll(() => harness.dispose())

  it(`is within 1/255 of the reference in ${cases} random cases`, async () => {
    const random = seeded(2008)
    let worst = 0
    // Each case is disposed after the next is drawn, so that the renderer keeps their common program.
    let release = () => {}
    for (let i = 0; i < cases; i++) {
      const count = 1 + Math.floor(random() * 64)
      const set = randomSet(random, count, 32)
      const scale = 0.2 + random() * 1.2
      const offset = [random() * 0.4 - 0.2, random() * 0.4 - 0.2]
      const activations = set.areas.map(() => (random() < 0.3 ? 0 : random() * (4 / count)))
      const { error, dispose } = await largestError(harness, set, activations, scale, offset)
      worst = Math.max(worst, error)
      release()
      release = dispose
    }
    release()
    expect(worst).toBeLessThanOrEqual(STEP)
  })
})

async function largestError(
  harness: Harness,
  set: WrinkleSet,
  activations: number[],
  scale: number,
  offset: number[],
) {
  const mesh = square(new MeshStandardMaterial(), scale, offset)
  const wrinkles = new harness.Wrinkles(mesh, set, { areaSize: 32 })
  const clamped = activations.map((activation) => Math.min(activation, 1))
  for (const [i, { name }] of set.areas.entries()) wrinkles.setActivation(name, clamped[i])
  return influenceError(harness, mesh, wrinkles, set, clamped, { scale, offset })
}

import type { LayerKind } from 'furrow'
import { afterAll, beforeAll, describe, expect, it } from 'vitest'
import { seeded } from '../random.ts'
import { createHarness, type Harness, RENDERERS, squareCamera } from './harness.ts'
import { mixingCase } from './mixing.ts'

const PIXELS = 32
const KINDS: LayerKind[][] = [
  ['replace'],
  ['detail'],
  ['replace', 'replace'],
  ['replace', 'detail'],
  ['detail', 'detail'],
  ['replace', 'replace', 'detail', 'detail'],
]

describe.each(RENDERERS)('the default mode on %s', (name) => {
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterAll(() => harness.dispose())

  it.each(KINDS)('mixes %s %s %s %s layers as the reference does', async (...kinds) => {
    const random = seeded(7)
    // Each case is let go after the next was drawn: renderers then keep the program that both have.
    let release = () => {}
    for (let i = 0; i < 10; i++) {
      const own = mixingCase(harness, random, kinds.filter(Boolean), { scale: 0.8, offset: 0.1 })
      for (const name of own.wrinkles.areaNames) own.wrinkles.setActivation(name, random() * 0.5)
      expect(await own.largestError(squareCamera(), PIXELS)).toBeLessThanOrEqual(2 / 255)
      // One area alone reaches a part of the map.
      for (const name of own.wrinkles.areaNames) {
        own.wrinkles.setActivation(name, name === `area${2 * (i % 6)}` ? 1 : 0)
      }
      expect(await own.largestError(squareCamera(), PIXELS)).toBeLessThanOrEqual(2 / 255)
      release()
      release = own.dispose
    }
    release()
  })
})

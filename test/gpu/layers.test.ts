import type { LayerKind } from 'furrow'
import { describe, expect, it } from 'vitest'
import { seeded } from '../random.ts'
import { casesIn, harnessOn, RENDERERS, squareCamera } from './harness.ts'
import { mixingCase } from './mixing.ts'

const PIXELS = 32
const CASES = casesIn(10)
const KINDS: LayerKind[][] = [
  ['replace'],
  ['detail'],
  ['replace', 'replace'],
  ['replace', 'detail'],
  ['detail', 'detail'],
  ['replace', 'replace', 'detail', 'detail'],
]

describe.each(RENDERERS)('the default mode on %s', (name) => {
  const harness = harnessOn(name)

  it.each(KINDS)('mixes %s %s %s %s layers as the reference does', async (...kinds) => {
    const random = seeded(7)
    // Disposes of a case only after the next one is drawn, so that the renderer keeps the program that all cases use.
    let release = () => {}
    for (let i = 0; i < CASES; i++) {
      const mixing = mixingCase(harness, random, kinds.filter(Boolean), { scale: 0.8, offset: 0.1 })
      for (const name of mixing.wrinkles.areaNames) mixing.wrinkles.setActivation(name, random() * 0.5)
      expect(await mixing.largestError(squareCamera(), PIXELS)).toBeLessThanOrEqual(2 / 255)
      // Activates one area at a time, which redraws only a part of the influence map.
      for (const name of mixing.wrinkles.areaNames) {
        mixing.wrinkles.setActivation(name, name === `area${2 * (i % 6)}` ? 1 : 0)
      }
      expect(await mixing.largestError(squareCamera(), PIXELS)).toBeLessThanOrEqual(2 / 255)
      release()
      release = mixing.dispose
    }
    release()
  })
})

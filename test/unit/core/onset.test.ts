import { parseWrinkleSetDocument } from 'furrow'
import { reference } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { checkWrinkleSet } from '../../../packages/furrow/src/core/wrinkle-set.ts'
import { seeded } from '../../random.ts'

const { onsetInfluence } = reference

describe('an onset', () => {
  it('changes nothing at influence 0 and 1, to the bit', () => {
    const random = seeded(1)
    for (let i = 0; i < 1000; i++) {
      const [onset, strength] = [random(), random()]
      expect(onsetInfluence(0, onset, strength)).toBe(0)
      expect(onsetInfluence(1, onset, strength)).toBe(1)
    }
    expect(onsetInfluence(0.37, 0.5, 0)).toBe(0.37)
    expect([0, 0.9, 1].map((influence) => onsetInfluence(influence, 1))).toEqual([0, 0, 1])
  })

  it('hides a texel until its influence, then never lets it fade again', () => {
    for (const onset of [0, 0.04, 0.2, 0.5, 0.9]) {
      expect(onsetInfluence(onset, onset)).toBeCloseTo(0, 12)
      let before = 0
      for (let influence = 0; influence <= 1; influence += 0.01) {
        const shown = onsetInfluence(influence, onset)
        expect(shown).toBeGreaterThanOrEqual(before)
        before = shown
      }
    }
  })

  it('shows the middle of an automatic line before its ends', () => {
    expect(onsetInfluence(0.3, 0.04)).toBeGreaterThan(0.4)
    expect(onsetInfluence(0.3, 0.5)).toBeLessThan(0.1)
  })

  it('refuses a strength out of range', () => {
    const document = (layer: object) => ({ layers: [{ name: 'skin', ...layer }], areas: [{ name: 'nose' }] })
    expect(() => parseWrinkleSetDocument(document({ onset: 'o.png', onsetStrength: 1.5 }))).toThrow(
      'layers[0].onsetStrength is out of range',
    )
    const gray = { width: 1, height: 1, data: new Uint8Array(1) }
    const normal = { width: 1, height: 1, data: new Uint8Array(4) }
    const layer = { name: 'skin', kind: 'detail' as const, normal, onset: gray, onsetStrength: -1 }
    expect(() => checkWrinkleSet({ layers: [layer], areas: [{ name: 'nose', weights: gray }] })).toThrow(
      'onsetStrength of layer "skin"',
    )
  })
})

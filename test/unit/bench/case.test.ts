import { describe, expect, it } from 'vitest'
import { createBlobs } from '../../../bench/blobs.ts'
import { activationOf, listCases } from '../../../bench/case.ts'

describe('bench cases', () => {
  it('are 2 to 256 areas, all active and 8 of 256, still and moving, 1 and 4 layers', () => {
    const cases = listCases(false)
    expect(new Set(cases.map((shown) => JSON.stringify(shown))).size).toBe(24)
    expect(cases).toContainEqual({ areas: 256, active: 8, layers: 4, still: true })
    expect(cases).toContainEqual({ areas: 16, active: 16, layers: 1, still: false })
  })

  it.each(listCases(false))('$areas areas, $active active, still: $still, layers: $layers', (shown) => {
    const frame = (at: number) => Array.from({ length: shown.areas }, (_, i) => activationOf(i, at, shown))
    for (const at of [0, 1, 7]) {
      expect(frame(at).filter((value) => value > 0 && value <= 1)).toHaveLength(shown.active)
      expect(frame(at)).toEqual(frame(at))
    }
    const moved = frame(1).filter((value, i) => value !== frame(0)[i])
    expect(moved).toHaveLength(shown.still ? 0 : shown.active)
  })
})

describe('bench blobs', () => {
  const places = new Float32Array([0.5, 0.25, 0.2, 0.8])

  it('are the same in every run, and fewer are the first of more', () => {
    expect(createBlobs(4, places, ['a', 'b'])).toEqual(createBlobs(8, places, ['a', 'b']).slice(0, 4))
  })

  it('are fullest at a place of the face and nothing far from it', () => {
    for (const { weights } of createBlobs(8, places, ['a'])) {
      const peak = weights.data.indexOf(Math.max(...weights.data))
      const [u, v] = [((peak % 128) + 0.5) / 128, (Math.floor(peak / 128) + 0.5) / 128]
      expect(Math.min(Math.hypot(u - 0.5, v - 0.25), Math.hypot(u - 0.2, v - 0.8))).toBeLessThan(0.01)
      expect(weights.data[peak]).toBeGreaterThan(245)
      expect(weights.data.filter((value) => value > 0).length / weights.data.length).toBeLessThan(0.032)
    }
  })

  it('take turns on the layers', () => {
    expect(createBlobs(4, places, ['a', 'b']).map(({ layer }) => layer)).toEqual(['a', 'b', 'a', 'b'])
  })
})

import { describe, expect, it } from 'vitest'
import { divideAreas } from '../../../bench/areas.ts'
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

describe('bench areas', () => {
  /** A bar of eight columns and a dot. */
  const bar = { width: 16, height: 2, data: new Uint8Array(32).fill(200, 4, 12) }
  const dot = { width: 16, height: 2, data: new Uint8Array(32).fill(255, 20, 21) }

  it("are the face's first ones where few are asked for", () => {
    const [first, ...others] = divideAreas([bar, dot], 1, ['a'])
    expect(others).toEqual([])
    expect(first).toEqual({ name: 'area0', layer: 'a', weights: bar })
  })

  it.each([2, 4, 8, 16])('cut into %d sum to what they were cut from', (count) => {
    const areas = divideAreas([bar, dot], count, ['a'])
    expect(areas).toHaveLength(count)
    for (const [k, whole] of [bar, dot].entries()) {
      const parts = areas.slice((k * count) / 2, ((k + 1) * count) / 2)
      const sum = [...whole.data.keys()].map((i) =>
        parts.reduce((all, { weights }) => all + weights.data[i], 0),
      )
      for (const [i, value] of sum.entries()) expect(Math.abs(value - whole.data[i])).toBeLessThanOrEqual(1)
    }
    const used = areas.slice(0, count / 2).map(({ weights }) => weights.data.some((weight) => weight > 0))
    expect(used).not.toContain(false)
  })

  it('take turns on the layers', () => {
    expect(divideAreas([bar, dot], 4, ['a', 'b']).map(({ layer }) => layer)).toEqual(['a', 'b', 'a', 'b'])
  })

  it('refuse a number that cannot be divided among them', () => {
    expect(() => divideAreas([bar, dot], 3, ['a'])).toThrow(/3 areas of 2/)
  })
})

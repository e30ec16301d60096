import { describe, expect, it } from 'vitest'
import { activationOf, listCases } from '../../../bench/case.ts'
import { divideAreas } from '../../../bench/page/areas.ts'

describe('bench cases', () => {
  it('include 2 to 256 areas, all or 8 of 256 active, still and moving, with 1 and 4 layers', () => {
    const cases = listCases(false)
    expect(new Set(cases.map((benchCase) => JSON.stringify(benchCase))).size).toBe(28)
    expect(cases).toContainEqual({ areas: 256, active: 8, layers: 4, maps: 'normals', still: true })
    expect(cases).toContainEqual({ areas: 16, active: 16, layers: 1, maps: 'normals', still: false })
    expect(cases).toContainEqual({ areas: 8, active: 8, layers: 1, maps: 'all', still: true })
    expect(cases).toContainEqual({ areas: 8, active: 8, layers: 1, maps: 'onset', still: false })
  })

  it.each(listCases(false))(
    '$areas areas, $active active, still: $still, layers: $layers, maps: $maps',
    (benchCase) => {
      const activations = (frame: number) =>
        Array.from({ length: benchCase.areas }, (_, i) => activationOf(i, frame, benchCase))
      for (const frame of [0, 1, 7]) {
        expect(activations(frame).filter((value) => value > 0 && value <= 1)).toHaveLength(benchCase.active)
        expect(activations(frame)).toEqual(activations(frame))
      }
      const moved = activations(1).filter((value, i) => value !== activations(0)[i])
      expect(moved).toHaveLength(benchCase.still ? 0 : benchCase.active)
    },
  )
})

describe('bench areas', () => {
  /** Two areas: a bar of eight columns, and a single texel. */
  const bar = { width: 16, height: 2, data: new Uint8Array(32).fill(200, 4, 12) }
  const dot = { width: 16, height: 2, data: new Uint8Array(32).fill(255, 20, 21) }

  it('are the first areas of the face if fewer are requested', () => {
    const [first, ...others] = divideAreas([bar, dot], 1, ['a'])
    expect(others).toEqual([])
    expect(first).toEqual({ name: 'area0', layer: 'a', weights: bar })
  })

  it.each([2, 4, 8, 16])('divided into %d sum to the originals', (count) => {
    const areas = divideAreas([bar, dot], count, ['a'])
    expect(areas).toHaveLength(count)
    for (const [k, original] of [bar, dot].entries()) {
      const strips = areas.slice((k * count) / 2, ((k + 1) * count) / 2)
      const sums = [...original.data.keys()].map((i) =>
        strips.reduce((sum, { weights }) => sum + weights.data[i], 0),
      )
      for (const [i, sum] of sums.entries()) expect(Math.abs(sum - original.data[i])).toBeLessThanOrEqual(1)
    }
    const used = areas.slice(0, count / 2).map(({ weights }) => weights.data.some((weight) => weight > 0))
    expect(used).not.toContain(false)
  })

  it('are assigned to the layers in turn', () => {
    expect(divideAreas([bar, dot], 4, ['a', 'b']).map(({ layer }) => layer)).toEqual(['a', 'b', 'a', 'b'])
  })

  it('refuse a number that is not a multiple', () => {
    expect(() => divideAreas([bar, dot], 3, ['a'])).toThrow(/3 areas of 2/)
  })
})

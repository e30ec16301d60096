import fc from 'fast-check'
import { packAreas, reference } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

const flat = (value: number) => ({ width: 2, height: 2, data: new Uint8Array(4).fill(value) })
const entry = (activation: number, combine: 'sum' | 'max' = 'sum', layer = 0) => ({
  activation,
  layer,
  combine,
})

describe('reference', () => {
  it('sums weights times activations, clamped to 1', () => {
    const areas = packAreas([flat(51), flat(102), flat(255)], 2)
    expect(reference.influence(areas, [entry(1), entry(0.5), entry(0)], 0.5, 0.5)).toBeCloseTo(0.4, 12)
    expect(reference.influence(areas, [entry(1), entry(1), entry(1)], 0.5, 0.5)).toBe(1)
  })

  it('combines an area by max instead of the sum', () => {
    const areas = packAreas([flat(102), flat(51), flat(204)], 2)
    const influence = reference.influence(areas, [entry(1), entry(1), entry(1, 'max')], 0.5, 0.5)
    expect(influence).toBeCloseTo(0.8, 12)
    const less = reference.influence(areas, [entry(1), entry(1), entry(0.5, 'max')], 0.5, 0.5)
    expect(less).toBeCloseTo(0.6, 12)
  })

  it('sums only the areas of the layer', () => {
    const areas = packAreas([flat(255), flat(51)], 2)
    expect(reference.influence(areas, [entry(1), entry(1, 'sum', 1)], 0.5, 0.5, 1)).toBeCloseTo(0.2, 12)
  })

  it('does not bleed between areas', () => {
    const areas = packAreas([flat(0), flat(255), flat(0)], 2)
    for (const v of [0, 0.25, 0.999, 1]) {
      expect(reference.sampleArray(areas, 0.5, v, 0)).toBe(0)
      expect(reference.sampleArray(areas, 0.5, v, 1)).toBe(1)
    }
  })

  it('does not change a colour where there is no influence', () => {
    fc.assert(
      fc.property(
        fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: 3, maxLength: 3 }),
        (colour) => {
          expect(reference.mixColours(colour, [0.1, 0.2, 0.3], 0)).toEqual(colour)
          expect(reference.mixColours([0.1, 0.2, 0.3], colour, 1)).toEqual(colour)
        },
      ),
    )
  })

  it('mixes the values of layers by their influences, which are divided by their sum if that exceeds 1', () => {
    const layer = (value: number, influence: number) => ({ value: [value], influence })
    expect(reference.mixValues([0.5], [layer(1, 0.5), layer(0, 0.2)])[0]).toBeCloseTo(0.65, 12)
    expect(reference.mixValues([0.5], [layer(1, 1), layer(0, 1)])[0]).toBeCloseTo(0.5, 12)
    expect(reference.mixValues([0.5], [layer(1, 0.9), layer(1, 0.9)])[0]).toBeCloseTo(1, 12)
  })

  it('unpacks a normal from -1 to 1', () => {
    expect(reference.unpackNormal([0, 0.5, 1])).toEqual([-1, 0, 1])
  })

  it('reorients details: a flat detail gives the base, and a flat base gives the detail', () => {
    const tilted = [0.6, 0, 0.8]
    expect(close(reference.reorientNormal(tilted, [0, 0, 1]), tilted)).toBe(true)
    expect(close(reference.reorientNormal([0, 0, 1], tilted), tilted)).toBe(true)
  })

  it('does not depend on the order of layers', () => {
    const layers = [
      { kind: 'replace' as const, normal: [0.5, 0.1, 0.8], influence: 0.7 },
      { kind: 'detail' as const, normal: [-0.3, 0.2, 0.9], influence: 0.4 },
      { kind: 'replace' as const, normal: [-0.2, 0.4, 0.85], influence: 0.9 },
      { kind: 'detail' as const, normal: [0.1, -0.4, 0.9], influence: 0.8 },
    ]
    const forwards = reference.mixNormals([0.05, 0, 1], layers)
    expect(close(forwards, reference.mixNormals([0.05, 0, 1], [...layers].reverse()))).toBe(true)
    expect(Math.hypot(...forwards)).toBeCloseTo(1, 12)
  })
})

function close(a: readonly number[], b: readonly number[]): boolean {
  return a.every((value, i) => Math.abs(value - b[i]) < 1e-12)
}

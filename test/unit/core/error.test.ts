import { FurrowError, parseWrinkleSetDocument } from 'furrow'
import { describe, expect, it } from 'vitest'

const parts = {
  code: 'out-of-range',
  who: 'setActivation',
  problem: 'activation out of range',
  value: 2,
  limit: '0..1',
  remedy: 'clamp it',
} as const

/** Returns the value that `work` throws. */
function thrown(work: () => unknown): unknown {
  try {
    return work()
  } catch (error) {
    return error
  }
}

describe('FurrowError', () => {
  it('keeps its parts and prints them in one line', () => {
    const error = new FurrowError(parts)
    expect(error).toMatchObject(parts)
    expect(error.message).toBe('setActivation: activation out of range, got 2, allowed: 0..1; clamp it')
  })

  it('has the code "invalid" by default, and prints no missing value or limit', () => {
    const error = new FurrowError({ who: 'bake', problem: 'no triangles', remedy: 'export the mesh' })
    expect(error).toMatchObject({ code: 'invalid', value: undefined, limit: undefined })
    expect(error.message).toBe('bake: no triangles; export the mesh')
  })

  it('can be reported by another function, with all other parts', () => {
    const error = new FurrowError(parts)
    const other = error.reportedBy('furrow render')
    expect(other).toMatchObject({ ...parts, who: 'furrow render', cause: error })
    expect(other.message).toBe(error.message.replace('setActivation', 'furrow render'))
  })

  const cyclic: { self?: unknown } = {}
  cyclic.self = cyclic
  it.each<[string, unknown, string]>([
    ['text', 'a\nb', '"a\\nb"'],
    ['null', null, 'null'],
    ['NaN', Number.NaN, 'NaN'],
    ['an array', [1, 'a'], '[1,"a"]'],
    ['an object without toString', Object.assign(Object.create(null), { a: 1 }), '{"a":1}'],
    ['a cyclic object', cyclic, 'an object'],
    ['long text', 'x'.repeat(200), `"${'x'.repeat(116)}...`],
  ])('prints %s', (_, value, text) => {
    expect(new FurrowError({ ...parts, value }).message).toContain(`, got ${text}, allowed`)
  })
})

describe('document errors', () => {
  const areas = [{ name: 'brow', image: 'brow.png' }]
  const layers = [{ name: 'age', normal: 'age.png' }]
  it.each<[string, object, object]>([
    ['a wrong type', { layers: 1 }, { code: 'invalid', value: 1 }],
    ['a missing field', { layers: [{ normal: 'age.png' }] }, { code: 'invalid', value: undefined }],
    ['a number out of range', { areaSize: 1e9 }, { code: 'out-of-range', value: 1e9 }],
    ['an unknown choice', { layers: [{ ...layers[0], kind: 'x' }] }, { code: 'unknown-name', value: 'x' }],
    ['too few items', { layers: [] }, { code: 'out-of-range', value: 0 }],
  ])('have a code and the value: %s', (_, fields, expected) => {
    const document = { version: 1, layers, areas, ...fields }
    expect(thrown(() => parseWrinkleSetDocument(document, 'wrinkles.json'))).toMatchObject({
      who: 'wrinkles.json',
      ...expected,
    })
  })

  it('report a missing field as missing', () => {
    const document = { version: 1, layers: [{ normal: 'age.png' }], areas }
    expect(() => parseWrinkleSetDocument(document, 'wrinkles.json')).toThrow(
      /layers\[0\]\.name must be text, got nothing/,
    )
  })
})

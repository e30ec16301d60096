import fc from 'fast-check'
import { areaWeights, FurrowError, parseWrinkleSetDocument, type WrinkleSet } from 'furrow'
import { checkWrinkleSet } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

const normal = { width: 2, height: 2, data: new Uint8Array(16) }
const weights = { width: 2, height: 2, data: new Uint8Array(4) }
const good: WrinkleSet = {
  layers: [{ name: 'skin', kind: 'replace', normal }],
  areas: [{ name: 'nose', weights }],
}

describe('checkWrinkleSet', () => {
  it('accepts a valid set', () => expect(() => checkWrinkleSet(good)).not.toThrow())

  it.each<[WrinkleSet, string]>([
    [{ ...good, areas: [] }, 'no areas, got 0, allowed: 1 to 256 areas; add at least one'],
    [{ ...good, layers: [] }, 'no layers, got 0, allowed: 1 to 4 layers'],
    [
      { ...good, layers: [0, 1, 2, 3, 4].map((i) => ({ name: `l${i}`, kind: 'detail' as const, normal })) },
      'too many layers, got 5, allowed: 1 to 4 layers',
    ],
    [
      { ...good, layers: [{ ...good.layers[0], height: weights }] },
      'invalid heightAmplitude of layer "skin", got "undefined", allowed: metres from black to white',
    ],
    ...[Number.NaN, Infinity, -0.001].map((heightAmplitude): [WrinkleSet, string] => [
      { ...good, layers: [{ ...good.layers[0], height: weights, heightAmplitude }] },
      'heightAmplitude of layer "skin"',
    ]),
    [
      { ...good, layers: [{ ...good.layers[0], height: { ...weights, width: 3 }, heightAmplitude: 0.001 }] },
      'layer "skin" height',
    ],
    [{ ...good, areas: [...good.areas, ...good.areas] }, 'two areas with the same name, got "nose"'],
    [{ ...good, areas: [{ name: '', weights }] }, 'area without a name, got ""'],
    [
      { ...good, areas: [{ name: 'nose', weights, layer: 'skim' }] },
      'area "nose" is on an unknown layer, got "skim", allowed: "skin"; did you mean "skin"?',
    ],
    [
      { ...good, areas: [{ name: 'nose', weights: { ...weights, width: 3 } }] },
      'WrinkleSet area "nose": wrong length of gray image data, got "4 bytes", allowed: 6 bytes for 3 x 2',
    ],
  ])('refuses %#: $1', (set, message) => {
    expect(() => checkWrinkleSet(set)).toThrow(new RegExp(message.replaceAll('(', '\\(')))
  })
})

describe('areaWeights', () => {
  const painted = { width: 2, height: 2, data: Uint8Array.of(255, 0, 128, 200) }

  it("inverts images in the paper's convention, where black is visible", () => {
    expect([...areaWeights(painted).data]).toEqual([0, 255, 127, 55])
    expect([...areaWeights(painted, 'weight').data]).toEqual([255, 0, 128, 200])
    expect([...painted.data]).toEqual([255, 0, 128, 200])
  })

  it('refuses a single texel', () => {
    expect(() => areaWeights({ width: 1, height: 1, data: Uint8Array.of(0) }, 'paper', 'dot.png')).toThrow(
      'dot.png: area image too small, got "1 x 1", allowed: at least 2 x 2 texels; paint the area',
    )
  })
})

describe('parseWrinkleSetDocument', () => {
  const document = {
    version: 1,
    layers: [{ name: 'skin', normal: 'n.png' }],
    areas: [{ name: 'nose', image: 'nose.png', later: true }],
  }

  it('fills in defaults, and drops unknown fields', () => {
    expect(parseWrinkleSetDocument(document)).toEqual({
      version: 1,
      layers: [{ name: 'skin', kind: 'replace', normal: 'n.png' }],
      areas: [{ name: 'nose', image: 'nose.png', combine: 'sum', convention: 'paper' }],
    })
  })

  it('requires only names; images have the default paths of a folder', () => {
    const least = parseWrinkleSetDocument({ layers: [{ name: 'skin' }], areas: [{ name: 'a#b' }] })
    expect(least.version).toBe(1)
    expect([least.layers[0].normal, least.areas[0].image]).toEqual([
      'layers/skin/normal.png',
      'areas/a%23b.png',
    ])
  })

  it.each<[unknown, string]>([
    [null, 'the document must be an object, got null; write { ... }'],
    [{ ...document, version: 2 }, 'unknown version, got 2, allowed: 1; write "version": 1'],
    [{ ...document, layers: {} }, 'layers must be an array, got {}, allowed: 1 to 4 items'],
    [{ ...document, areas: [] }, 'areas has the wrong number of items, got 0, allowed: 1 to 256 items'],
    [
      { ...document, areas: [{ name: 'nose', image: '' }] },
      'areas[0].image must be text, got "", allowed: 1 to 2048 characters',
    ],
    [
      { ...document, areas: [{ name: 'a', image: 'b', combine: 'min' }] },
      'areas[0].combine is unknown, got "min", allowed: sum or max; use one of them',
    ],
  ])('refuses %j', (json, message) => {
    expect(() => parseWrinkleSetDocument(json)).toThrow(message)
  })

  it('returns a document or throws a FurrowError, whatever the input', () => {
    fc.assert(
      fc.property(fc.jsonValue(), (json) => {
        try {
          expect(parseWrinkleSetDocument(json).version).toBe(1)
        } catch (error) {
          expect(error).toBeInstanceOf(FurrowError)
        }
      }),
      { numRuns: 2000 },
    )
  })
})

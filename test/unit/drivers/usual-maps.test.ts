import fc from 'fast-check'
import { parseWrinkleMaps, type WrinkleMaps } from 'furrow'
import { describe, expect, it } from 'vitest'
import { IDENTITY } from '../../../packages/furrow/src/drivers/curve.ts'
import { readUsualMaps } from '../../../packages/furrow/src/drivers/usual-maps.ts'
import { MUTATED, mutate, mutation } from '../gltf/mutations.ts'

const TEXTURES = 6
const FILE = {
  extensionsUsed: ['FURROW_wrinkle_maps'],
  textures: [...Array(TEXTURES).fill({}), { extensions: { KHR_texture_basisu: { source: 0 } } }],
}
const morph = { type: 'morph', area: 'brow', targets: [{ name: 'browInnerUp' }] }

/** Every field that is usual. */
const usual = {
  layers: [
    {
      name: 'up',
      kind: 'detail',
      normalTexture: { index: 0, scale: -2, texCoord: 0 },
      baseColorTexture: { index: 1 },
      roughnessTexture: { index: 2 },
      occlusionTexture: { index: 3, strength: 0.5 },
      heightTexture: { index: 4, amplitude: 0.001 },
      bloodTexture: { index: 3, amplitude: 2 },
    },
    { name: 'down', normalTexture: { index: 5 }, bloodTexture: { index: 3, amplitude: 1 } },
  ],
  areas: [
    { name: 'brow', texture: { index: 1 } },
    { name: 'nose', layer: 1, texture: { index: 2 }, channel: 3, combine: 'max', activation: 0.2 },
  ],
  drivers: [
    {
      ...morph,
      targets: [{ name: 'browInnerUp', weight: 0.5 }, { name: 'jawOpen' }],
      rule: 'sum',
      curve: [
        [0, 0],
        [0.5, 0.2],
        [1, 1],
      ],
    },
    morph,
  ],
}

function parse(json: unknown): WrinkleMaps | undefined {
  try {
    return parseWrinkleMaps(json, TEXTURES)
  } catch {
    return undefined
  }
}

describe('readUsualMaps', () => {
  it('reads what is usual as parseWrinkleMaps does', () => {
    expect(readUsualMaps(usual, FILE)).toEqual(parseWrinkleMaps(usual, TEXTURES))
    const { drivers: _, ...still } = usual
    expect(readUsualMaps(still, FILE)).toEqual(parseWrinkleMaps(still, TEXTURES))
  })

  it('reads all mutated documents as that does, or not at all', () => {
    const text = JSON.stringify(usual)
    let [read, left, refused] = [0, 0, 0]
    fc.assert(
      fc.property(fc.array(mutation, { minLength: 1, maxLength: 3 }), (mutations) => {
        const document = mutations.reduce(mutate, JSON.parse(text))
        const [maps, parsed] = [readUsualMaps(document, FILE), parse(document)]
        if (!parsed) refused++
        else if (maps) read++
        else left++
        if (maps) expect(maps).toEqual(parsed)
      }),
      { numRuns: MUTATED, seed: 5 },
    )
    // Of those that are sound few are left: slices, and drivers of other types.
    expect(read).toBeGreaterThan(MUTATED / 20)
    expect(refused).toBeGreaterThan(0.3 * MUTATED)
    expect(left).toBeLessThan(read / 4)
  })

  it.each<[string, object]>([
    ['slices', { layers: [{ name: 'up', normalTexture: { index: 0, slice: 0 } }] }],
    ['drivers of another type', { drivers: [morph, { type: 'age', area: 'brow' }] }],
    ['a driver of another rule', { drivers: [{ ...morph, rule: 'max' }] }],
    ['a link with a curve', { drivers: [{ ...morph, targets: [{ name: 'jawOpen', curve: IDENTITY }] }] }],
    ['a KTX 2 image', { areas: [{ name: 'brow', texture: { index: TEXTURES } }] }],
    ['a malformed driver', { drivers: [morph, { ...morph, area: 'chin' }] }],
    ['drivers that are null', { drivers: null }],
  ])('leaves %s to that', (_, changes) => {
    expect(readUsualMaps({ ...usual, ...changes }, FILE)).toBeUndefined()
  })
})

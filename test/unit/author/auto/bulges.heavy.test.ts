import {
  AUTO_REGIONS,
  type AutoOptions,
  type AutoWrinkles,
  autoWrinkles,
  type GrayImage,
  type Skin,
} from 'furrow/author'
import { BULGES_FROM, LINE_REGIONS } from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import { driven } from '../../../driven.ts'
import { skinAt } from '../../../skin-at.ts'
import { same } from '../planes.ts'
import { FACES } from './faces.ts'

const REGIONS = ['bag', 'hood', 'cheek', 'jowl'] as const
const NAMES = REGIONS.flatMap((region) => [`${region}Left`, `${region}Right`])
/** Range of the heights at 70 years, in millimetres. */
const HEIGHTS = [1.2, 3] as const
/** Maximum slope that areas show at 80 years. */
const STEEPEST = 0.85

const make = (skin: Skin, options: AutoOptions) =>
  autoWrinkles(skin, { size: 512, areaSize: 128, ...options })

/** Returns the weight of an area, 0..1, at a texel of a square map with another size. */
function weightAt({ width, data }: GrayImage, texel: number, size: number): number {
  const [x, y] = [texel % size, Math.floor(texel / size)].map((at) => Math.floor((at * width) / size))
  return data[y * width + x]! / 255
}

describe.each(FACES)('%s', (_, path) => {
  let skin: Skin
  let old: AutoWrinkles
  const activations = (age: number) =>
    driven(old.bulges.map(({ driver }) => driver)).activations({ inputs: { age } })
  const layerOf = () => old.layers[old.bulges[0].layer]

  beforeAll(async () => {
    skin = await skinAt(path)
    old = make(skin, { age: 70, regions: REGIONS })
  })

  test('has bags, hoods, cheeks and jowls on a layer without lines', () => {
    expect(old.bulges.map(({ name }) => name).toSorted()).toEqual(NAMES.toSorted())
    expect(new Set(old.bulges.map(({ layer }) => layer)).size).toBe(1)
    expect(layerOf().onset).toBeUndefined()
    expect(new Set(layerOf().strokes.map(({ group }) => group))).toEqual(new Set(NAMES))
  })

  test.each(NAMES)('shows nothing of %s at 35, little at 50, and 1.2 to 3 mm at 70', (name) => {
    expect(activations(BULGES_FROM)[name]).toBe(0)
    expect(activations(50)[name]).toBeLessThan(0.5 * activations(70)[name]!)
    const { weights } = old.bulges.find((bulge) => bulge.name === name)!
    const { heights } = layerOf()
    const activation = activations(70)[name]!
    let highest = 0
    for (const [i, height] of heights.data.entries()) {
      highest = Math.max(highest, weightAt(weights, i, heights.width) * height * activation)
    }
    expect(highest).toBeGreaterThan(HEIGHTS[0])
    expect(highest).toBeLessThan(HEIGHTS[1])
  })

  test('shows gentle slopes', () => {
    const { width, height, data } = layerOf().normal
    let most = 0
    for (let texel = 0; texel < width * height; texel++) {
      const z = data[4 * texel + 2]! / 127.5 - 1
      const slope = Math.sqrt(1 - z * z) / z
      for (const { weights } of old.bulges) most = Math.max(most, slope * weightAt(weights, texel, width))
    }
    expect(most).toBeGreaterThan(0.3)
    expect(most).toBeLessThan(STEEPEST)
  })

  test('has the same lines as without bulges', () => {
    const [lines, both] = [LINE_REGIONS, AUTO_REGIONS].map((regions) => make(skin, { age: 70, regions }))
    expect(lines.bulges).toEqual([])
    expect(both.bulges[0].layer).toBe(lines.layers.length)
    for (const [i, layer] of lines.layers.entries()) {
      expect(same(layer.normal.data, both.layers[i].normal.data)).toBe(true)
      expect(same(lines.blood.maps[i].data, both.blood.maps[i].data)).toBe(true)
    }
    expect(both.areas).toEqual(lines.areas)
  })
})

test('bulges alone need no lines', async () => {
  const skin = await skinAt(FACES[0][1])
  const { bulges, areas, layers, emptyReason } = make(skin, { age: 60, regions: ['jowl'], size: 64 })
  expect(bulges.map(({ name }) => name)).toEqual(['jowlLeft', 'jowlRight'])
  expect([areas.length, layers.length, emptyReason]).toEqual([0, 1, undefined])
  expect(make(skin, { age: 30, regions: ['jowl'] }).emptyReason).toBe(
    'the chosen regions only bulge above the age of 35 years',
  )
})

test('bulges differ between left and right, and between seeds', async () => {
  const skin = await skinAt(FACES[0][1])
  const [old, other] = [1, 2].map((seed) => make(skin, { age: 70, seed, size: 64, regions: REGIONS }))
  const depthsOf = ({ layers, bulges }: AutoWrinkles, side: string) =>
    layers[bulges[0].layer].strokes
      .filter(({ group }) => group!.endsWith(side))
      .map(({ depth, width }) => `${depth} ${width}`)
  expect(depthsOf(old, 'Left')).not.toEqual(depthsOf(old, 'Right'))
  expect(depthsOf(old, 'Left')).not.toEqual(depthsOf(other, 'Left'))
})

test.each([{}, { age: BULGES_FROM }])(
  'a face has no bulges with %j, and does not miss them',
  async (options) => {
    const skin = await skinAt(FACES[0][1])
    const young = make(skin, { ...options, size: 64 })
    expect(young.bulges).toEqual([])
    expect(young.missing.map(({ name }) => name)).not.toContain('bagLeft')
  },
)

test('bulges need a layer beside two with lines', async () => {
  const skin = await skinAt(FACES[0][1])
  const { bulges, missing } = make(skin, { age: 70, layers: 2, size: 64 })
  expect(bulges).toEqual([])
  expect(missing).toContainEqual({
    name: 'bagLeft',
    reason: 'it needs a separate layer, beside 2 with lines',
  })
})

import type { MorphDriver, TimeDriver } from 'furrow'
import { type AutoWrinkles, autoWrinkleSet, autoWrinkles, type Skin } from 'furrow/author'
import { checkWrinkleSet } from 'furrow/internal'
import { describe, expect, test } from 'vitest'
import { skinAt } from '../../../skin-at.ts'
import { FACES } from './faces.ts'
import { sheet } from './sheet.ts'

const SETTINGS = { age: 50, size: 256, areaSize: 128 }
const FLUSHES = [
  'flushBrows',
  'flushCheekLeft',
  'flushCheekRight',
  'flushNoseLeft',
  'flushNoseRight',
  'paleLips',
]

describe.each(FACES)('blood of %s', async (_, path) => {
  const skin = await skinAt(path)
  const wrinkles = autoWrinkles(skin, SETTINGS)
  const { blood, areas, layers } = wrinkles
  const flushOf = (name: string) => blood.areas.find((area) => area.name === name)!

  /** Returns the amount of blood at the strongest point of a flush, an area that reddens or pales: -127..127, 0 is neutral. */
  const middleOf = (name: string) => {
    const { layer, weights } = flushOf(name)
    const best = weights.data.indexOf(Math.max(...weights.data))
    const scale = blood.maps[layer].width / weights.width
    const [x, y] = [best % weights.width, Math.floor(best / weights.width)].map((i) =>
      Math.floor((i + 0.5) * scale),
    )
    return blood.maps[layer].data[y * blood.maps[layer].width + x] - 128
  }

  test('reddens brows, nose and cheeks, and pales the lips', () => {
    expect(blood.areas.map(({ name }) => name).sort()).toEqual(FLUSHES)
    for (const name of FLUSHES.slice(0, 5)) expect(middleOf(name), name).toBeGreaterThan(60)
    expect(middleOf('paleLips')).toBeLessThan(-40)
  })

  test('is driven by targets of the face, reddens over seconds, and pales immediately', () => {
    const names = skin.targets.map(({ name }) => name)
    for (const { name, drivers } of blood.areas) {
      const [morph, time] = drivers as [MorphDriver, TimeDriver]
      for (const target of morph.targets) expect(names).toContain(target.name)
      expect([morph.area, time.area]).toEqual([name, name])
      expect(time.release).toBeGreaterThan(time.attack)
    }
    expect((flushOf('flushCheekLeft').drivers[0] as MorphDriver).targets).toContainEqual({
      name: expect.stringMatching(/smile.*(left|l)$/i),
      weight: 1,
    })
    expect(flushOf('flushBrows').drivers[1].attack).toBeGreaterThan(0.5)
    expect(flushOf('paleLips').drivers[1].attack).toBeLessThan(0.2)
  })

  test('areas do not show the wrinkle lines of their layer', () => {
    for (const { name, layer, weights } of blood.areas) {
      const { heights } = layers[layer]
      const scale = heights.width / weights.width
      let deepest = 0
      for (let i = 0; i < weights.data.length; i++) {
        const x = Math.floor(((i % weights.width) + 0.5) * scale)
        const y = Math.floor((Math.floor(i / weights.width) + 0.5) * scale)
        deepest = Math.max(deepest, (weights.data[i] / 255) * Math.abs(heights.data[y * heights.width + x]))
      }
      expect(deepest, name).toBeLessThan(0.05)
    }
  })

  test('shows less than a tenth of its strength in the areas of wrinkle lines on the same layer', () => {
    for (const { name, layer, weights } of areas) {
      const { data, width } = blood.maps[layer]
      const scale = width / weights.width
      let most = 0
      for (const [i, weight] of weights.data.entries()) {
        const x = Math.floor(((i % weights.width) + 0.5) * scale)
        const y = Math.floor((Math.floor(i / weights.width) + 0.5) * scale)
        // Skips wrinkle valleys, which have blood too.
        if (layers[layer].heights.data[y * width + x] === 0)
          most = Math.max(most, (weight / 255) * Math.abs(data[y * width + x] - 128))
      }
      expect(most, name).toBeLessThan(12.7)
    }
  })

  test('is slightly stronger in valleys, and neutral on skin without lines or flushes', () => {
    for (const [i, { heights }] of layers.entries()) {
      const { data } = blood.maps[i]
      const flushed = blood.areas.filter(({ layer }) => layer === i).length > 0
      let valley = 0
      let plain = 0
      for (const [texel, height] of heights.data.entries()) {
        if (height < -0.3) valley = Math.max(valley, data[texel] - 128)
        if (height === 0 && data[texel] !== 128) plain++
      }
      if (Math.min(...heights.data) < -0.3) expect(valley).toBeGreaterThan(10)
      expect(plain > 0).toBe(flushed)
    }
  })

  test('grows with the strength, and does not change the lines', () => {
    const strong = autoWrinkles(skin, { ...SETTINGS, strength: 2 })
    expect(strong.blood.amplitude).toBeCloseTo(2 * blood.amplitude, 3)
    expect(blood.amplitude).toBeLessThan(0.5)
    expect(autoWrinkles(skin, { ...SETTINGS, strength: 0 }).blood.amplitude).toBe(0)
    expect(areas.map(({ name }) => name)).not.toContain('flushBrows')
  })

  test('has areas only in the requested regions', () => {
    const { blood } = autoWrinkles(skin, { ...SETTINGS, regions: ['nose', 'crowsFeet'] })
    expect(blood.areas.map(({ name }) => name)).toEqual(['flushNoseLeft', 'flushNoseRight'])
  })

  test('is deterministic, and a valid part of the set', () => {
    expect(autoWrinkles(skin, SETTINGS).blood).toEqual(blood)
    const set = autoWrinkleSet(wrinkles)
    checkWrinkleSet(set)
    expect(set.areas).toHaveLength(areas.length + FLUSHES.length + wrinkles.bulges.length)
    expect(set.drivers.filter(({ type }) => type === 'time')).toHaveLength(FLUSHES.length)
  })
})

test('skin that is no face has valleys, and no flushes', () => {
  const { positions, uvs, indices, offsets } = sheet(20, 0)
  const skin: Skin = {
    positions: positions.map((mm) => mm / 1000),
    uvs,
    indices,
    targets: [{ name: 'bend', offsets: offsets.map((mm) => mm / 1000) }],
  }
  const { blood, layers }: AutoWrinkles = autoWrinkles(skin, { size: 256, areaSize: 64 })
  expect(blood.areas).toEqual([])
  expect(blood.maps).toHaveLength(layers.length)
  expect(Math.max(...blood.maps[0].data)).toBeGreaterThan(128)
  expect(Math.min(...blood.maps[0].data)).toBe(128)
})

import {
  type AutoOptions,
  type AutoWrinkles,
  autoWrinkles,
  parseStrokes,
  type Skin,
  skinCanvas,
} from 'furrow/author'
import { addFurrows, strokesOf } from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import { driven } from '../../../driven.ts'
import { skinAt } from '../../../skin-at.ts'
import { FACES } from './faces.ts'

const [, HUMAN] = FACES[0]
const SIZE = 2048
const AREAS = ['Forehead', 'Brows', 'EyeLeft', 'EyeRight', 'CheekLeft', 'CheekRight', 'Neck'].map(
  (name) => `furrows${name}`,
)

let skin: Skin
const made = new Map<number, AutoWrinkles>()
const make = (options: AutoOptions) => autoWrinkles(skin, { size: SIZE, furrows: true, ...options })

beforeAll(async () => {
  skin = await skinAt(HUMAN)
  for (const age of [30, 50, 70]) made.set(age, make({ age }))
})

const heightsOf = ({ layers }: AutoWrinkles) => layers.at(-1)!.heights

/** Returns the activations of the areas that show fine furrows. */
function activations(weights: Readonly<Record<string, number>>): Record<string, number> {
  const names = skin.targets.map(({ name }) => name)
  const drivers = made.get(50)!.furrows!.areas.map(({ driver }) => driver)
  const pose = Float32Array.from(names, (name) => weights[name] ?? 0)
  return driven(drivers, names).activations({ weights: pose })
}

/** Returns the heights of the fine furrows at texels where the area's weight is high. */
function within(wrinkles: AutoWrinkles, name: string): Float32Array {
  const { width, data } = wrinkles.furrows!.areas.find((area) => area.name === name)!.weights
  return heightsOf(wrinkles).data.filter((_, texel) => {
    const [column, row] = [texel % SIZE, Math.floor(texel / SIZE)].map((at) =>
      Math.floor((at * width) / SIZE),
    )
    return data[row * width + column] > 200
  })
}

describe('fine furrows', () => {
  test('have a separate layer after those of wrinkle lines, with areas by region', () => {
    const { layers, furrows, areas, blood } = made.get(50)!
    expect(layers.length).toBeLessThanOrEqual(4)
    expect(layers.map(({ name }) => name).indexOf('furrows')).toBe(layers.length - 1)
    expect(blood.maps).toHaveLength(layers.length)
    expect(furrows!.areas.map(({ name }) => name)).toEqual(expect.arrayContaining(AREAS))
    expect(furrows!.areas.every(({ layer }) => layer === layers.length - 1)).toBe(true)
    for (const { layer } of [...areas, ...blood.areas]) expect(layer).toBeLessThan(layers.length - 1)
  })

  test('have areas whose weights sum to 1 where they meet', () => {
    const { areas } = made.get(50)!.furrows!
    let [full, touched] = [0, 0]
    for (let texel = 0; texel < areas[0].weights.data.length; texel++) {
      const weights = areas.map(({ weights }) => weights.data[texel])
      const sum = weights.reduce((a, b) => a + b, 0)
      expect(sum).toBeLessThanOrEqual(255 + areas.length)
      if (weights.filter((weight) => weight > 20).length < 2) continue
      touched++
      if (sum > 250) full++
    }
    expect(full / touched).toBeGreaterThan(0.9)
  })

  test('are drawn identically from the strokes document', () => {
    const wrinkles = made.get(70)!
    const document = parseStrokes(JSON.parse(JSON.stringify(strokesOf(wrinkles))))
    const drawn = { width: SIZE, height: SIZE, data: new Float32Array(SIZE * SIZE) }
    addFurrows(drawn, skinCanvas(skin, SIZE, SIZE, document.scale), document.furrows!, document.strokes)
    const off = drawn.data.filter((height, i) => Math.abs(height - heightsOf(wrinkles).data[i]) > 1e-4).length
    expect(off / drawn.data.length).toBeLessThan(1e-4)
  })

  test('have half their depth at rest, more on squeezed skin and less on stretched skin', () => {
    for (const value of Object.values(activations({}))) expect(value).toBeCloseTo(0.5, 6)
    const frown = activations({ browDownLeft: 1, browDownRight: 1, noseSneerLeft: 1, noseSneerRight: 1 })
    expect(frown.furrowsBrows).toBeGreaterThan(0.75)
    const surprise = activations({ browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 })
    expect(surprise.furrowsForehead).toBeGreaterThan(0.55)
    expect(surprise.furrowsBrows).toBeLessThan(0.45)
    const open = activations({ jawOpen: 1 })
    expect(open.furrowsCheekLeft).toBeLessThan(0.35)
    const squint = activations({ cheekSquintLeft: 1 })
    expect(squint.furrowsEyeLeft).toBeGreaterThan(squint.furrowsEyeRight + 0.1)
  })

  test.each(['furrowsForehead', 'furrowsEyeLeft', 'furrowsCheekLeft', 'furrowsNeck'])(
    'have the measured depth of skin at rest, and deepen with age: %s',
    (name) => {
      const depths = [30, 50, 70].map((age) => {
        const heights = within(made.get(age)!, name).sort()
        // The first percentile is the depth of the bottoms of furrows. Half of it shows at rest.
        return -0.5 * heights[Math.floor(heights.length / 100)]
      })
      // Primary and secondary lines of skin are 0.02 to 0.2 mm deep (Bibb 2006, Medical Modelling, 6.17.3).
      for (const depth of depths) expect(depth).toBeGreaterThan(0.02)
      for (const depth of depths) expect(depth).toBeLessThan(0.2)
      expect(depths[1]).toBeGreaterThan(1.05 * depths[0])
      expect(depths[2]).toBeGreaterThan(1.2 * depths[1])
    },
  )

  test('are constant until forty, and then have fewer and longer cells (Corcuff 1983, Lagarde 2005)', () => {
    const cells = [30, 50, 70].map((age) => made.get(age)!.furrows!.furrows)
    for (const k of [1, 2]) {
      expect(cells[k].size).toBeGreaterThan(cells[k - 1].size)
      expect(cells[k].stretch).toBeGreaterThan(cells[k - 1].stretch)
    }
    for (const { regions = [] } of cells) {
      for (const { size } of regions) {
        expect(size).toBeGreaterThan(0.5)
        expect(size).toBeLessThan(3)
      }
    }
  })

  test('are left out if texels are too large, with a message that names a sufficient size', () => {
    const { layers, furrows, missing } = make({ size: 512 })
    expect(furrows).toBeUndefined()
    expect(layers.map(({ name }) => name)).not.toContain('furrows')
    const { reason } = missing.find(({ name }) => name === 'furrowsForehead')!
    expect(reason).toBe('fine furrows are narrower than two texels there; use a size of 2048')
  })

  test('follow regions, strength and seed, and are deterministic', () => {
    const regions = ['foreheadInner', 'foreheadOuter', 'glabella'] as const
    const [first, again, other] = [1, 1, 2].map((seed) =>
      make({ regions, strength: 2, age: 50, layers: 2, seed }),
    )
    expect(first.layers.map(({ name }) => name)).toEqual(['auto1', 'furrows'])
    expect(first.furrows!.areas.map(({ name }) => name)).toEqual(['furrowsForehead', 'furrowsBrows'])
    expect(first.furrows!.furrows.depth).toBeCloseTo(2 * made.get(50)!.furrows!.furrows.depth, 3)
    const isSame = (a: AutoWrinkles, b: AutoWrinkles) =>
      Buffer.compare(Buffer.from(heightsOf(a).data.buffer), Buffer.from(heightsOf(b).data.buffer)) === 0
    expect(isSame(first, again)).toBe(true)
    expect(isSame(first, other)).toBe(false)
  })

  test('are refused if no layer is left for them', () => {
    expect(() => make({ layers: 1 })).toThrow('fine furrows need a separate layer')
  })

  test('are off by default', () => {
    expect(autoWrinkles(skin, { size: 512 }).furrows).toBeUndefined()
  })
})

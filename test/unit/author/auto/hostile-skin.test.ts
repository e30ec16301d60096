import { autoWrinkles, skinCanvas } from 'furrow/author'
import { expect, test } from 'vitest'
import { checkCoverage } from '../../../../packages/furrow/src/author/skin/check-coverage.ts'
import { SkinTexels } from '../../../../packages/furrow/src/author/skin/skin-texels.ts'
import { weldSurface } from '../../../../packages/furrow/src/author/skin/surface.ts'
import { seeded } from '../../../random.ts'
import { sheet } from './sheet.ts'

const repeated = <T>(list: ArrayLike<T>, times: number): T[] =>
  Array.from({ length: times }, () => Array.from(list)).flat()

test('hundreds of overlapping triangles are refused', () => {
  const { uvs, indices } = sheet(8, 0)
  expect(() => checkCoverage({ uvs, indices: repeated(indices, 20) }, 'test')).not.toThrow()
  expect(() => checkCoverage({ uvs, indices: repeated(indices, 200) }, 'test')).toThrow(
    'too many overlapping triangles in UV space',
  )
})

test('strokes are not drawn on overlapping triangles', () => {
  const { positions, uvs, indices } = sheet(8, 0)
  expect(() => skinCanvas({ positions, uvs, indices: repeated(indices, 200) }, 16)).toThrow(
    'skinCanvas: too many overlapping triangles in UV space',
  )
})

test('a skin that is too large for the scale of strokes documents is refused', () => {
  const { positions, uvs, indices } = sheet(8, 0)
  const targets = [{ name: 'press', offsets: positions.map((x) => -0.1 * x) }]
  const skin = { positions: positions.map((x) => 1e14 * x), uvs, indices, targets }
  expect(() => autoWrinkles(skin)).toThrow('autoWrinkles: the skin is far too large for a character')
})

test('triangles outside the texture do not count as overlapping', () => {
  const { uvs, indices } = sheet(8, 0)
  expect(() => checkCoverage({ uvs: uvs.map((x) => 1000 * x + 2), indices }, 'test')).not.toThrow()
})

test('duplicate triangles do not change the borders', () => {
  const corner = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], uvs: [0.4, 0.4, 0.5, 0.4, 0.4, 0.5] }
  const located = (times: number) => {
    const skin = { ...corner, indices: repeated([0, 1, 2], times) }
    const texels = new SkinTexels(skin, weldSurface(skin), 64, 64)
    const weights = new Float64Array(3)
    return Array.from({ length: 64 * 64 }, (_, texel) => texels.locate(texel, weights))
  }
  expect(located(50)).toEqual(located(1))
})

test('borders are searched for once, however many triangles lack neighbours', () => {
  const { positions, uvs } = sheet(20, 0)
  const random = seeded(7)
  const indices = Array.from({ length: 3 * 2000 }, () => Math.floor((random() * uvs.length) / 2))
  const surface = weldSurface({ positions, indices })
  let searched = 0
  const adjacent = new Proxy(surface.adjacent, {
    get: (list, key) => {
      if (key !== 'length') searched++
      return Reflect.get(list, key)
    },
  })
  new SkinTexels({ uvs, indices }, { ...surface, adjacent }, 64, 64)
  expect(searched).toBe(surface.corners.length)
})

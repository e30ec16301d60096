import { skinCanvas } from 'furrow/author'
import { addFurrows, FINE_FURROW_DEFAULTS } from 'furrow/internal'
import { expect, test } from 'vitest'
import { skinAt } from '../../../skin-at.ts'
import { cutInTwo, findCuts, halfTurn } from './cuts.ts'
import { FACES } from './faces.ts'

const SIZE = 1024
/** Options for large furrows, which are seven texels wide. */
const FURROWS = { ...FINE_FURROW_DEFAULTS, size: 9, depth: 0.1 }

test('fine furrows are equally deep on both sides of a UV seam', async () => {
  const [, path] = FACES[0]
  const skin = await skinAt(path)
  const isSecond = (triangle: number) =>
    [0, 1, 2].every((k) => skin.uvs[2 * skin.indices[3 * triangle + k]] <= 0.5)
  const { cut } = cutInTwo(skin, isSecond, halfTurn)
  const drawn = { width: SIZE, height: SIZE, data: new Float32Array(SIZE * SIZE) }
  addFurrows(drawn, skinCanvas(cut, SIZE), FURROWS, [])
  const at = ([u, v]: readonly [number, number]) => {
    const [x, y] = [u * SIZE - 0.5, v * SIZE - 0.5]
    const [x0, y0] = [Math.floor(x), Math.floor(y)]
    const across = (row: number) =>
      drawn.data[row * SIZE + x0] * (1 - x + x0) + drawn.data[row * SIZE + x0 + 1] * (x - x0)
    return across(y0) * (1 - y + y0) + across(y0 + 1) * (y - y0)
  }
  const pairs = findCuts(cut)
    .map(({ sides }) => sides.map(({ uv }) => at(uv)))
    .filter((pair) => Math.min(...pair) < -0.02)
  expect(pairs.length).toBeGreaterThan(100)
  const rms = Math.sqrt(pairs.reduce((sum, [a, b]) => sum + (a - b) ** 2, 0) / pairs.length)
  expect(rms / FURROWS.depth).toBeLessThan(0.05)
})

import { strainMaps } from 'furrow/internal'
import { describe, expect, test } from 'vitest'

/** Width of the sheet (metres) and of the map (texels). */
const SIDE = 0.2
const SIZE = 64

/** Returns a sheet that uses the left half of its texture, and has blendshapes that shorten it in x and in y. */
function skin(n: number) {
  const [positions, uvs, indices, across, up]: number[][] = [[], [], [], [], []]
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) {
      const [x, y] = [(SIDE * i) / n, (SIDE * j) / n]
      positions.push(x, y, 0)
      uvs.push(i / n / 2, 1 - j / n)
      across.push(-0.1 * x, 0, 0)
      up.push(0, -0.06 * y, 0)
      const p = j * (n + 1) + i
      if (i < n && j < n) indices.push(p, p + 1, p + n + 2, p, p + n + 2, p + n + 1)
    }
  }
  const targets = [
    { name: 'across', offsets: across },
    { name: 'up', offsets: up },
  ]
  return { positions, uvs, indices, targets }
}

describe('strain maps', () => {
  // The expected value is the larger principal compression, and 0 if the skin is only stretched.
  test.each<[Record<string, number>, number]>([
    [{ across: 1 }, 0.1],
    [{ across: 0.5, up: 0.5 }, 0.05],
    [{ up: 1, across: -1 }, 0.06],
    [{ across: -1 }, 0],
    [{}, 0],
    [{ nothing: 1 }, 0],
  ])('of %j', (pose, compression) => {
    const [map] = strainMaps(skin(12), [pose], SIZE)
    expect([map.width, map.height, map.data.length]).toEqual([SIZE, SIZE, SIZE * SIZE])
    for (let row = 0; row < SIZE; row++) {
      for (let column = 0; column < SIZE / 2; column++) {
        expect(Math.abs(map.data[row * SIZE + column] - compression)).toBeLessThan(1e-6)
      }
    }
  })

  test('are the same for a skin in another UV tile', () => {
    const first = skin(12)
    const moved = { ...first, uvs: first.uvs.map((value, i) => value + (i % 2 === 0 ? 2 : -1)) }
    const [map, expected] = [moved, first].map((sheet) => strainMaps(sheet, [{ across: 1 }], SIZE)[0].data)
    for (const [i, compression] of expected.entries()) {
      if (Number.isNaN(compression)) expect(map[i]).toBeNaN()
      else expect(map[i]).toBeCloseTo(compression, 6)
    }
  })

  test('are empty where no skin is', () => {
    const [map] = strainMaps(skin(3), [{ across: 1 }], SIZE)
    for (let row = 0; row < SIZE; row++) {
      for (let column = SIZE / 2 + 4; column < SIZE; column++) expect(map.data[row * SIZE + column]).toBeNaN()
    }
  })
})

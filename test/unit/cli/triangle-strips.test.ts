import { documentOf, findSkin } from 'furrow-files'
import { describe, expect, test } from 'vitest'
import { decodeGlb } from '../../../packages/files/src/gltf/glb-file.ts'
import { editGlb } from '../../glb.ts'
import { sheet, sheetGlb } from './sheet.ts'

const [STRIP, FAN] = [5, 6]

/** Returns the triangles of a sheet whose indices form a strip or fan. Each begins with its lowest vertex. */
async function trianglesOf(squares: number, mode: number, indices: readonly number[]): Promise<string[]> {
  const file = await sheetGlb({ ...sheet(squares), indices: Uint32Array.from(indices) })
  const edited = editGlb(file, ({ meshes }) => {
    meshes[0].primitives[0].mode = mode
  })
  const { skin } = findSkin(
    await documentOf(decodeGlb(edited, 'strip.glb', 'test'), 'strip.glb', 'test'),
    'strip.glb',
    'test',
  )
  return turned(skin.indices)
}

function turned(indices: ArrayLike<number>): string[] {
  const triangles = Array.from({ length: indices.length / 3 }, (_, t) => {
    const corners = [0, 1, 2].map((k) => indices[3 * t + k]!)
    const first = corners.indexOf(Math.min(...corners))
    return [0, 1, 2].map((k) => corners[(first + k) % 3]).join()
  })
  return triangles.sort()
}

describe('a skin made of', () => {
  test('a strip has the triangles of the list with the same orientation, without the degenerate ones that join rows', async () => {
    const squares = 3
    // Each row runs from left to right. Repeated vertices at its end and at the start of the next row join the rows.
    const strip: number[] = []
    for (let row = 0; row < squares; row++) {
      const first = row * (squares + 1)
      if (row > 0) strip.push(strip.at(-1)!, first)
      for (let i = first; i <= first + squares; i++) strip.push(i, i + squares + 1)
    }
    // The strip and the sheet split squares along different diagonals.
    const list = Array.from({ length: squares ** 2 }, (_, i) => i + Math.floor(i / squares)).flatMap((a) => {
      const c = a + squares + 1
      return [a, c, a + 1, a + 1, c, c + 1]
    })
    expect(await trianglesOf(squares, STRIP, strip)).toEqual(turned(list))
  })

  test('a fan has the triangles around its first vertex', async () => {
    expect(await trianglesOf(1, FAN, [0, 2, 3, 1])).toEqual(turned([0, 2, 3, 0, 3, 1]))
  })

  test('millions of strips are refused', async () => {
    const many = Array.from({ length: 4_000_001 }, (_, i) => i % 4)
    await expect(trianglesOf(1, STRIP, many)).rejects.toThrow(/strips and fans have more than 4,000,000/)
  })
})

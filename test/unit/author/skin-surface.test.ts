import { fileURLToPath } from 'node:url'
import { mapSkin, skinSurface } from 'furrow/internal'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { describe, expect, it } from 'vitest'

const HUMAN = fileURLToPath(new URL('../../../faces/human.glb', import.meta.url))

describe('the surface of a skin', () => {
  it('of a face has the coordinates of the face, whatever its rotation and scale', async () => {
    const { skin } = findSkin(await readDocument(HUMAN, 'test'), HUMAN, 'test')
    const { surface, scale } = skinSurface(skin)
    // Rotates by a quarter turn about y, doubles the size, and moves the points.
    const turned = (vectors: ArrayLike<number>, [x, y, z]: readonly number[]) =>
      Float64Array.from({ length: vectors.length }, (_, i) => {
        const first = i - (i % 3)
        return [2 * vectors[first + 2] + x, 2 * vectors[first + 1] + y, -2 * vectors[first] + z][i % 3]
      })
    const other = skinSurface({
      ...skin,
      positions: turned(skin.positions, [1, 2, 3]),
      targets: skin.targets.map(({ name, offsets }) => ({ name, offsets: turned(offsets, [0, 0, 0]) })),
    })
    expect(other.scale).toBeCloseTo(scale / 2, 6)
    const differences = surface.points.map((value, i) => Math.abs(value - other.surface.points[i]))
    expect(differences.reduce((a, b) => Math.max(a, b))).toBeLessThan(1e-3)
  })

  const sheet = {
    positions: [0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0.2, 0, 0, 0.3, 0, 0, 0.2, 0.1, 0],
    uvs: [0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0],
    indices: [0, 1, 2, 3, 4, 5],
    targets: [],
  }

  it('without a face is in millimetres, in the coordinates of the mesh', () => {
    const { surface, scale } = skinSurface(sheet)
    expect(scale).toBe(1000)
    expect([...surface.points.slice(3, 6)]).toEqual([100, 0, 0])
  })

  it('lists a texel of several triangles once more for each triangle after the first', () => {
    const { surface } = skinSurface(sheet)
    const { texels } = mapSkin(sheet, surface, 16)
    const own: number[] = []
    texels.visit((texel, triangle, a, b, c) => {
      if (triangle === 0 && Math.min(a, b, c) > 1e-3) own.push(texel)
    })
    const others: number[] = []
    texels.visitOverlaps((texel, triangle) => {
      expect(triangle).toBe(1)
      others.push(texel)
    })
    expect(others).toEqual(own)
    expect(own.length).toBeGreaterThan(80)
  })

  it('is drawn on both sides, but only on one side where both share texels', () => {
    // A sheet across the middle, and a triangle on each side. Both triangles use the same half of the texture.
    const body = {
      positions: [
        [-0.1, 0, 0, 0.1, 0, 0, -0.1, 0.1, 0, 0.1, 0.1, 0],
        [0.3, 0, 0, 0.4, 0, 0, 0.3, 0.1, 0],
        [-0.3, 0, 0, -0.4, 0, 0, -0.3, 0.1, 0],
      ].flat(),
      uvs: [0, 1, 0.4, 1, 0, 0, 0.4, 0, 0.5, 1, 1, 1, 0.5, 0, 0.5, 1, 1, 1, 0.5, 0],
      indices: [0, 1, 2, 1, 3, 2, 4, 5, 6, 7, 9, 8],
      targets: [],
    }
    const { surface } = skinSurface(body)
    const drawn = new Set<number>()
    mapSkin(body, surface, 64).texels.visit((_, triangle) => drawn.add(triangle))
    expect([...drawn].sort()).toEqual([0, 1, 2])
  })
})

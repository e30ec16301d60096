import { simplify, weld } from '@gltf-transform/functions'
import { type AutoWrinkles, autoWrinkles } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import { beforeAll, describe, expect, test } from 'vitest'
import type { LaidStroke } from '../../../../packages/furrow/src/author/strokes/lay-out.ts'
import { FACES, facialCreases, prepareFace } from './faces.ts'

const AGE = 50
const SIZE = 512
/** Width of the squares in which heights are compared, texels. It corresponds to 3 to 4 mm of skin. */
const SQUARE = 8

/** Characters in games often have about 2,000 vertices on the skin of the head. */
describe('the shipped face with a sixth of its triangles', () => {
  let [full, low]: DrawnFace[] = []

  beforeAll(async () => {
    await MeshoptSimplifier.ready
    full = await draw(1)
    low = await draw(0.16)
  })

  test('has about 2,000 vertices', () => {
    expect(low.vertices).toBeLessThan(2600)
    expect(low.vertices).toBeGreaterThan(1500)
  })

  test('has lines in similar directions, with bends at most 20 degrees sharper', () => {
    for (const [name, creases] of full.regions) {
      const simplified = low.regions.get(name) ?? []
      // Crow's feet and lines of the nose fan out. Their mean directions differ, because the meshes have different numbers of lines.
      const tolerance = /crowsFeet|nose[LR]/.test(name) ? 20 : 8
      expect(angleBetween(meanDirection(creases), meanDirection(simplified)), name).toBeLessThan(tolerance)
      expect(turnOf(simplified)).toBeLessThan(20 + turnOf(creases))
    }
  })

  test('has similar heights in each square of 8 x 8 texels', () => {
    const [lowHeights, fullHeights] = [heightsOf(low.wrinkles), heightsOf(full.wrinkles)]
    expect(correlation(lowHeights, fullHeights)).toBeGreaterThan(0.85)
    const ratio = sum(lowHeights) / sum(fullHeights)
    expect(ratio).toBeGreaterThan(0.75)
    expect(ratio).toBeLessThan(1.35)
  })
})

interface DrawnFace {
  vertices: number
  wrinkles: AutoWrinkles
  regions: Map<string, readonly LaidStroke[]>
}

async function draw(ratio: number): Promise<DrawnFace> {
  const [[, path]] = FACES
  const document = await readDocument(path, 'test')
  if (ratio < 1)
    await document.transform(weld(), simplify({ simplifier: MeshoptSimplifier, ratio, error: 1 }))
  const { skin } = findSkin(document, path, 'test')
  const regions = facialCreases(prepareFace(skin), (AGE - 20) / 60)
  return {
    vertices: skin.positions.length / 3,
    wrinkles: autoWrinkles(skin, { age: AGE, size: SIZE }),
    regions: new Map(regions.map(({ region, creases }) => [region.name, creases])),
  }
}

/** Sums the absolute heights of all layers in each square of texels. These sums hardly depend on the exact place of lines. */
function heightsOf({ layers }: AutoWrinkles): Float64Array {
  const side = SIZE / SQUARE
  const squares = new Float64Array(side * side)
  for (const { heights } of layers) {
    for (const [i, height] of heights.data.entries()) {
      const [column, row] = [i % SIZE, Math.floor(i / SIZE)].map((k) => Math.floor(k / SQUARE))
      squares[row * side + column] += Math.abs(height)
    }
  }
  return squares
}

function sum(values: Float64Array): number {
  return values.reduce((a, b) => a + b, 0)
}

function correlation(a: Float64Array, b: Float64Array): number {
  const dot = (x: Float64Array, y: Float64Array) => sum(x.map((value, i) => value * y[i]))
  return dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b))
}

/** Returns the mean direction of wrinkle lines, weighted by length and depth. Opposite directions count as equal. */
function meanDirection(creases: readonly LaidStroke[]): number[] {
  const sum = [0, 0, 0]
  for (const { points, depths } of creases) {
    for (let i = 0; i + 1 < depths.length; i++) {
      const segment = [0, 1, 2].map((k) => points[3 * i + 3 + k] - points[3 * i + k])
      const sign = segment.reduce((dot, value, k) => dot + value * sum[k], 0) < 0 ? -1 : 1
      for (let k = 0; k < 3; k++) sum[k] += sign * depths[i] * segment[k]
    }
  }
  return sum
}

function angleBetween(a: readonly number[], b: readonly number[]): number {
  const dot = a.reduce((sum, value, k) => sum + value * b[k], 0)
  return (Math.acos(Math.min(1, Math.abs(dot) / Math.hypot(...a) / Math.hypot(...b))) * 180) / Math.PI
}

/** Returns the 95th percentile, over all points, of the angle by which lines turn within 2 mm, degrees. */
function turnOf(creases: readonly LaidStroke[]): number {
  const turns = creases.flatMap(({ points, depths }) => {
    const spacing = Math.hypot(...[0, 1, 2].map((k) => points[3 + k] - points[k])) || 1
    const step = Math.max(1, Math.round(1 / spacing))
    const out: number[] = []
    for (let i = step; i + step < depths.length; i++) {
      const segments = [i - step, i].map((from) =>
        [0, 1, 2].map((k) => points[3 * (from + step) + k] - points[3 * from + k]),
      )
      out.push(angleBetween(segments[0], segments[1]))
    }
    return out
  })
  return turns.sort((a, b) => a - b)[Math.floor(0.95 * turns.length)] ?? 0
}

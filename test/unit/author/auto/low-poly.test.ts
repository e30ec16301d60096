import { simplify, weld } from '@gltf-transform/functions'
import { type AutoWrinkles, autoWrinkles } from 'furrow/author'
import { MeshoptSimplifier } from 'meshoptimizer/simplifier'
import { beforeAll, describe, expect, test } from 'vitest'
import { findSkin } from '../../../../packages/cli/src/auto/read-skin.ts'
import { readDocument } from '../../../../packages/cli/src/face.ts'
import type { Crease } from '../../../../packages/furrow/src/author/auto/crease.ts'
import { findFace } from '../../../../packages/furrow/src/author/auto/face.ts'
import { faceRegions } from '../../../../packages/furrow/src/author/auto/face-regions.ts'
import { FACES } from './faces.ts'

const AGE = 50
const SIZE = 512

/** A head as games have it: about 2,000 vertices on the skin. */
describe('the shipped face with a sixth of its vertices', () => {
  let [full, low]: Drawn[] = []

  beforeAll(async () => {
    await MeshoptSimplifier.ready
    full = await draw(1)
    low = await draw(0.11)
  })

  test('has about 2,000', () => {
    expect(low!.vertices).toBeLessThan(2600)
    expect(low!.vertices).toBeGreaterThan(1500)
  })

  test('has the same areas', () => {
    console.log(low!.vertices, low!.wrinkles.areas.map(({ name }) => name).join(), full!.wrinkles.areas.length, low!.wrinkles.layers.length)
    const sharp = require('sharp')
    for (const [n, d] of [['full', full], ['low', low]] as const) { const r = total(d!.wrinkles); sharp(Uint8Array.from(r, (v: number) => Math.max(0, Math.min(255, 200 + 160 * v))), { raw: { width: SIZE, height: SIZE, channels: 1 } }).png().toFile(`/tmp/${n}.png`) }
    for (const [name, creases] of full!.regions) {
      const other = low!.regions.get(name)
      if (!other) { console.log(name, 'none'); continue }
      console.log(name, angleBetween(wayOf(creases), wayOf(other)).toFixed(2), turn(creases).toFixed(2), turn(other).toFixed(2))
    }
    console.log('corr', correlation(total(full!.wrinkles), total(low!.wrinkles)), total(full!.wrinkles).reduce((a, b) => a + b * b, 0), total(low!.wrinkles).reduce((a, b) => a + b * b, 0))
  })
})

interface Drawn {
  vertices: number
  wrinkles: AutoWrinkles
  regions: Map<string, readonly Crease[]>
}

async function draw(ratio: number): Promise<Drawn> {
  const [[, path]] = FACES as [readonly [string, string]]
  const document = await readDocument(path, 'test')
  if (ratio < 1) await document.transform(weld(), simplify({ simplifier: MeshoptSimplifier, ratio, error: 1 }))
  const { skin } = findSkin(document, path, 'test')
  const regions = faceRegions(findFace(skin)!, (AGE - 20) / 60, 1, 1)
  return {
    vertices: skin.positions.length / 3,
    wrinkles: autoWrinkles(skin, { age: AGE, size: SIZE }),
    regions: new Map(regions.map(({ region, creases }) => [region.name, creases])),
  }
}

/** All layers at once, in millimetres. */
function total({ layers }: AutoWrinkles): Float32Array {
  const sum = new Float32Array(SIZE * SIZE)
  for (const { relief } of layers) for (let i = 0; i < sum.length; i++) sum[i]! += relief.data[i]!
  return sum
}

function correlation(a: Float32Array, b: Float32Array): number {
  const dot = (x: Float32Array, y: Float32Array) => x.reduce((sum, value, i) => sum + value * y[i]!, 0)
  return dot(a, b) / Math.sqrt(dot(a, a) * dot(b, b))
}

/** The mean way of lines, whichever end they begin at, by length and depth. */
function wayOf(creases: readonly Crease[]): number[] {
  const sum = [0, 0, 0]
  for (const { points, depths } of creases) {
    for (let i = 0; i + 1 < depths.length; i++) {
      const way = [0, 1, 2].map((k) => points[3 * i + 3 + k]! - points[3 * i + k]!)
      const sign = way.reduce((dot, value, k) => dot + value * sum[k]!, 0) < 0 ? -1 : 1
      for (let k = 0; k < 3; k++) sum[k]! += sign * depths[i]! * way[k]!
    }
  }
  return sum
}

function angleBetween(a: readonly number[], b: readonly number[]): number {
  const dot = a.reduce((sum, value, k) => sum + value * b[k]!, 0)
  return (Math.acos(Math.min(1, Math.abs(dot) / Math.hypot(...a) / Math.hypot(...b))) * 180) / Math.PI
}

/** How far lines turn within two millimetres, in degrees: of all places, the one that a twentieth exceed. */
function turn(creases: readonly Crease[]): number {
  const turns = creases.flatMap(({ points, depths }) => {
    const spacing = Math.hypot(...[0, 1, 2].map((k) => points[3 + k]! - points[k]!)) || 1
    const step = Math.max(1, Math.round(1 / spacing))
    const out: number[] = []
    for (let i = step; i + step < depths.length; i++) {
      const ways = [i - step, i].map((from) => [0, 1, 2].map((k) => points[3 * (from + step) + k]! - points[3 * from + k]!))
      out.push(angleBetween(ways[0]!, ways[1]!))
    }
    return out
  })
  return turns.sort((a, b) => a - b)[Math.floor(0.95 * turns.length)] ?? 0
}

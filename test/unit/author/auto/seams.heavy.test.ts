import { autoWrinkles, heightToNormal, type Skin } from 'furrow/author'
import { type SkinSurface, surfaceMetric } from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import type { CreasedRegion } from '../../../../packages/furrow/src/author/auto/lines/crease.ts'
import { drawAreas } from '../../../../packages/furrow/src/author/auto/raster/draw-areas.ts'
import { MIPMAP_MARGIN } from '../../../../packages/furrow/src/author/border.ts'
import { SkinTexels } from '../../../../packages/furrow/src/author/skin/skin-texels.ts'
import { drawStrokes } from '../../../../packages/furrow/src/author/strokes/height.ts'
import { Rng } from '../../../../packages/furrow/src/math/rng.ts'
import { skinAt } from '../../../skin-at.ts'
import { type CutPoint, type CutSide, cutInTwo, findCuts, halfTurn, quarterTurn } from './cuts.ts'
import { FACES, facialCreases, prepareFace } from './faces.ts'
import { SIDE, sheet } from './sheet.ts'
import { type Channels, levelsOf, sample, slopeIn } from './slopes.ts'

const SIZE = 512
const AREA_SIZE = 128
/** Age fraction at 70 years. The fraction is 0 at 20 years and 1 at 80 years. */
const AGE = 5 / 6

/*
 * Largest differences allowed between the two sides of a UV seam, as fractions of the map's range. The sides differ for three reasons:
 * - Maps continue beyond a seam in the plane of the triangle, although the skin is curved.
 * - Texels are wide: 0.5 to 0.8 mm in layers, and 2 to 3 mm in areas. The weights of areas fade over 4 mm.
 * - Texel sizes are measured on each side. At the nose they differ by 10%.
 */
const HEIGHT = 0.012
const SHADE = 0.03
const WEIGHT = 0.12
const SLOPE = 0.12

/** The seam is at the middle of the face, where wrinkle lines of forehead, nose, lips, chin and neck cross it. */
describe.each(FACES)('%s, its texture cut in two at the middle', (_, path) => {
  let face: CutFace
  let [whole, cut]: DrawnFace[] = []
  let points: CutPoint[]

  beforeAll(async () => {
    face = await cutFace(path)
    whole = draw(face.whole, face, MIPMAP_MARGIN)
    cut = draw(face.cut, face, MIPMAP_MARGIN)
    points = findCuts(face.cut)
  })

  /** Returns the largest difference of a map between the two sides of all seams. */
  const difference = (map: Channels) =>
    largest(points, ([first, second]) => Math.abs(sample(map, first.uv) - sample(map, second.uv)))

  /** Returns the largest difference of slopes between the two sides of all seams, as a fraction of the steepest slope. */
  const slopeDifference = (drawn: DrawnFace, level: number) =>
    largest(points, (sides) => {
      const [first, second] = sides.map((side) => slopeIn(face.cut, drawn.levels[level], side))
      return Math.hypot(...first.map((value, k) => value - second[k]))
    }) / drawn.steepest

  test('has wrinkle lines across the seam', () => {
    const deepest = largest(points, ([{ uv }]) => Math.abs(sample(cut.heights, uv)))
    expect(deepest / cut.deepest).toBeGreaterThan(0.2)
    const steepest = largest(points, ([side]) => Math.hypot(...slopeIn(face.cut, cut.levels[0], side)))
    expect(steepest / cut.steepest).toBeGreaterThan(0.4)
  })

  test('has the same heights as the uncut face', () => {
    // In both layouts, texel centres are at the same points of the skin, so heights need no filtering. Heights differ only at the seam. The bottom
    // of a valley is rounded by the texel size. At a vertex, the texel size is the mean over the triangles around it. At a vertex on the seam of
    // the cut face, only the triangles on one side count.
    let [atCut, elsewhere] = [0, 0]
    for (let texel = 0; texel < SIZE * SIZE; texel++) {
      const [column, row] = [texel % SIZE, Math.floor(texel / SIZE)]
      const isSecond = column < SIZE * 0.475
      const sameColumn = isSecond ? 279 - column : column
      const same = isSecond ? (SIZE - 1 - row) * SIZE + sameColumn : texel
      if (!cut.inside[texel] || !whole.inside[same]) continue
      const error = Math.abs(cut.heights.data[texel] - whole.heights.data[same]) / cut.deepest
      if (Math.abs(sameColumn - SIZE / 2) < 16) atCut = Math.max(atCut, error)
      else elsewhere = Math.max(elsewhere, error)
    }
    expect(elsewhere).toBeLessThan(2e-4)
    expect(atCut).toBeLessThan(8e-3)
  })

  test('has equal height, occlusion and area weights on both sides of every seam', () => {
    const { surface } = face
    const texels = new SkinTexels(face.cut, surface, AREA_SIZE, AREA_SIZE)
    expect(difference(cut.heights) / cut.deepest).toBeLessThan(HEIGHT)
    expect(difference(cut.occlusion) / 255).toBeLessThan(SHADE)
    for (const area of drawAreas(texels, face.regions)) {
      expect(difference({ ...area, channels: 1 }) / 255).toBeLessThan(WEIGHT)
    }
  })

  test.each([0, 1, 2, 3])('has equal slopes on both sides of the seam at mipmap level %d', (level) => {
    expect(slopeDifference(cut, level)).toBeLessThan(SLOPE)
  })

  test.each([1, 2, 3])('shows nothing from outside the islands at the seam, at mipmap level %d', (level) => {
    const error = largest(points, ([first, second]) => {
      // Compares only the first island, which has not moved.
      const side = first.uv[0] > 0.475 ? first : second
      const [slope, uncut] = [cut, whole].map(({ levels }) => slopeIn(face.cut, levels[level], side))
      return Math.hypot(...slope.map((value, k) => value - uncut[k]))
    })
    expect(error / whole.steepest).toBeLessThan(SLOPE)
  })

  test('would have a visible seam if maps did not continue beyond the islands', () => {
    const ended = draw(face.cut, face, 0)
    expect(difference(ended.heights) / ended.deepest).toBeGreaterThan(HEIGHT)
    expect(slopeDifference(ended, 0)).toBeGreaterThan(5 * SLOPE)
    expect(slopeDifference(ended, 1)).toBeGreaterThan(2 * SLOPE)
  })
})

describe('a sheet, its texture cut in two', () => {
  const { positions, uvs, indices, offsets } = sheet(20, 25)
  const inMetres = (values: readonly number[]) => values.map((value) => value / 1000)
  const skin = {
    positions: inMetres(positions),
    uvs,
    indices,
    targets: [{ name: 'shorten', offsets: inMetres(offsets) }],
  }
  const isLeft = (triangle: number) =>
    [0, 1, 2].reduce((sum, k) => sum + positions[3 * indices[3 * triangle + k]] / 3, 0) < SIDE / 2
  const { whole, cut } = cutInTwo(skin, isLeft, quarterTurn)
  const turned = cutInTwo(skin, () => true, quarterTurn).cut
  const [onWhole, onCut, onTurned] = [mapsOf(whole), mapsOf(cut), mapsOf(turned)]
  const deepest = onWhole.heights.data.reduce((most, height) => Math.max(most, -height), 0)
  const steepest = steepestOf(onWhole.levels[0])

  test('has the same wrinkles in space', () => {
    expect(onCut.areas.length).toBe(onWhole.areas.length)
    expect(onWhole.areas.length).toBeGreaterThan(0)
    const rng = new Rng(1, 'points')
    let [height, weight] = [0, 0]
    for (let triangle = 0; triangle < indices.length / 3; triangle++) {
      for (let i = 0; i < 20; i++) {
        const along = rng.uniform(0, 1)
        const across = rng.uniform(0, 1 - along)
        const [uncutUv, cutUv] = [whole, cut].map((sheet) =>
          uvAt(sheet, triangle, [1 - along - across, along, across]),
        )
        height = Math.max(height, Math.abs(sample(onWhole.heights, uncutUv) - sample(onCut.heights, cutUv)))
        for (const [k, area] of onWhole.areas.entries())
          weight = Math.max(weight, Math.abs(sample(area, uncutUv) - sample(onCut.areas[k], cutUv)))
      }
    }
    // Texels are 0.1 mm wide on the first island and 0.2 mm on the second. The bottom of a valley may lie between two wide texels.
    expect(height / deepest).toBeLessThan(0.03)
    expect(weight / 255).toBeLessThan(0.03)
  })

  test.each([0, 1, 2, 3])('has the slopes of uncut skin at the seam, at mipmap level %d', (level) => {
    const points = findCuts(cut)
    expect(points.length).toBeGreaterThan(0)
    const error = largest(points, ([first, second]) => {
      const sides = first.uv[0] > 0.475 ? [first, second] : [second, first]
      const differences = sides.map((side, k) => {
        const slope = slopeIn(cut, onCut.levels[level], side)
        const uncut = slopeIn(cut, [onWhole, onTurned][k].levels[level], side)
        return Math.hypot(...slope.map((value, i) => value - uncut[i]))
      })
      return Math.max(...differences)
    })
    expect(error / steepest).toBeLessThan(0.02)
  })
})

/** Makes automatic wrinkles for a sheet, and returns their maps. */
function mapsOf(skin: Skin) {
  const { layers, areas } = autoWrinkles(skin, { age: 70, size: 1024, areaSize: 256 })
  return {
    heights: { ...layers[0].heights, channels: 1 },
    levels: levelsOf(layers[0].normal, 3),
    areas: areas.map(({ weights }) => ({ ...weights, channels: 1 })),
  }
}

/** Returns the UV of a point in a triangle. */
function uvAt({ uvs, indices }: Skin, triangle: number, barycentrics: readonly number[]): CutSide['uv'] {
  const [u, v] = [0, 1].map((k) =>
    barycentrics.reduce((sum, weight, j) => sum + weight * uvs[2 * indices[3 * triangle + j] + k], 0),
  )
  return [u, v]
}

interface CutFace {
  whole: Skin
  cut: Skin
  surface: SkinSurface
  regions: CreasedRegion[]
}

interface DrawnFace {
  heights: Channels
  occlusion: Channels
  /** Normal map and its mipmap levels. */
  levels: Channels[]
  /** 1 for texels that the skin covers, otherwise 0. */
  inside: Uint8Array
  /** Greatest depth, millimetres, and steepest slope, millimetres per millimetre. */
  deepest: number
  steepest: number
}

/** Cuts the UV layout of a face in two, and makes wrinkle lines on it. */
async function cutFace(path: string): Promise<CutFace> {
  const skin = await skinAt(path)
  const isRight = (triangle: number) =>
    [0, 1, 2].reduce((sum, k) => sum + skin.positions[3 * skin.indices[3 * triangle + k]], 0) < 0
  const skins = cutInTwo(skin, isRight, halfTurn)
  const prepared = prepareFace(skins.cut)
  return { ...skins, surface: prepared.surface, regions: facialCreases(prepared, AGE) }
}

/** Draws all wrinkle lines on one layer. */
function draw(skin: Skin, { surface, regions }: CutFace, margin: number): DrawnFace {
  const texels = new SkinTexels(skin, surface, SIZE, SIZE, undefined, margin)
  const positions = Array.from(skin.positions, (_, i) => {
    const vertex = Math.floor(i / 3)
    return surface.points[3 * surface.pointOf[vertex] + (i % 3)] / 1000
  })
  const metric = surfaceMetric({ ...skin, positions }, SIZE)
  const { heights, occlusion } = drawStrokes([...new Set(regions.map(({ creases }) => creases))].flat(), {
    texels,
    metric,
  })
  const levels = levelsOf(heightToNormal(heights, metric), 3)
  return {
    heights: { ...heights, channels: 1 },
    occlusion: { ...occlusion, channels: 1 },
    levels,
    inside: metric.inside,
    deepest: heights.data.reduce((most, height) => Math.max(most, -height), 0),
    steepest: steepestOf(levels[0]),
  }
}

function steepestOf({ data }: Channels): number {
  let most = 0
  for (let i = 0; i < data.length; i += 4) {
    const [x, y, z] = [0, 1, 2].map((k) => data[i + k] / 127.5 - 1)
    most = Math.max(most, Math.hypot(x, y) / z)
  }
  return most
}

function largest(points: readonly CutPoint[], of: (sides: CutPoint['sides']) => number): number {
  return points.reduce((most, { sides }) => Math.max(most, of(sides)), 0)
}

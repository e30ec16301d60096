import { autoWrinkles, heightToNormal, type Skin } from 'furrow/author'
import { type SkinSurface, surfaceMetric } from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import type { CreasedRegion } from '../../../../packages/furrow/src/author/auto/lines/crease.ts'
import { drawAreas } from '../../../../packages/furrow/src/author/auto/raster/draw-areas.ts'
import { MIPMAP_MARGIN } from '../../../../packages/furrow/src/author/border.ts'
import { SkinTexels } from '../../../../packages/furrow/src/author/skin/skin-texels.ts'
import { drawStrokes } from '../../../../packages/furrow/src/author/strokes/height.ts'
import { Rng } from '../../../../packages/furrow/src/math/rng.ts'
import { type CutPoint, type CutSide, cutInTwo, findCuts, halfTurn, quarterTurn } from './cuts.ts'
import { FACES, facialCreases, prepareFace, skinAt } from './faces.ts'
import { SIDE, sheet } from './sheet.ts'
import { type Channels, levelsOf, sample, slopeIn } from './slopes.ts'

const SIZE = 512
const AREA_SIZE = 128
/** Age fraction of 70 years: 0 at 20, 1 at 80. */
const AGE = 5 / 6

/*
 * Largest differences at a cut, as fractions of the range. Beyond a cut the skin is extended in a plane for filtering, so the sides differ
 * by the skin's curvature within a texel. A texel of the layers is 0.5 to 0.8 mm wide here, one of the areas 2 to 3 mm; an area fades over
 * at least 4 mm. Texel sizes are measured on one side's triangles and differ by a tenth at the bridge of the nose.
 */
const HEIGHT = 0.01
const SHADE = 0.01
const WEIGHT = 0.1
const SLOPE = 0.12

/** Forehead, nose, lips, chin and neck crease across the middle. The face's own cuts are tested too. */
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

  /** Returns the largest difference of a map between the two sides of a cut. */
  const difference = (map: Channels) =>
    largest(points, ([first, second]) => Math.abs(sample(map, first.uv) - sample(map, second.uv)))

  /** Returns the largest difference of slopes, as a fraction of the steepest. */
  const slopeDifference = (drawn: DrawnFace, level: number) =>
    largest(points, (sides) => {
      const [first, second] = sides.map((side) => slopeIn(face.cut, drawn.levels[level], side))
      return Math.hypot(...first.map((value, k) => value - second[k]))
    }) / drawn.steepest

  test('is creased at the cut', () => {
    const deepest = largest(points, ([{ uv }]) => Math.abs(sample(cut.heights, uv)))
    expect(deepest / cut.deepest).toBeGreaterThan(0.2)
    const steepest = largest(points, ([side]) => Math.hypot(...slopeIn(face.cut, cut.levels[0], side)))
    expect(steepest / cut.steepest).toBeGreaterThan(0.4)
  })

  test('has the same heights as the uncut face', () => {
    // Texels have the same positions, so nothing is filtered. Only triangles at the cut differ: their texel sizes, which limit how sharp
    // valleys are, are averages at vertices, which the cut duplicates.
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
    expect(atCut).toBeLessThan(3e-3)
  })

  test('has equal height, shading and areas on both sides of every cut', () => {
    const { surface } = face
    const texels = new SkinTexels(face.cut, surface, AREA_SIZE, AREA_SIZE)
    expect(difference(cut.heights) / cut.deepest).toBeLessThan(HEIGHT)
    expect(difference(cut.occlusion) / 255).toBeLessThan(SHADE)
    for (const area of drawAreas(texels, face.regions)) {
      expect(difference({ ...area, channels: 1 }) / 255).toBeLessThan(WEIGHT)
    }
  })

  test.each([0, 1, 2, 3])('has equal slopes at the cut at level %d', (level) => {
    expect(slopeDifference(cut, level)).toBeLessThan(SLOPE)
  })

  test.each([1, 2, 3])('shows no background at the cut at level %d', (level) => {
    const error = largest(points, ([first, second]) => {
      // The first island did not move.
      const side = first.uv[0] > 0.475 ? first : second
      const [slope, uncut] = [cut, whole].map(({ levels }) => slopeIn(face.cut, levels[level], side))
      return Math.hypot(...slope.map((value, k) => value - uncut[k]))
    })
    expect(error / whole.steepest).toBeLessThan(SLOPE)
  })

  test('would have a seam if the skin ended at its islands', () => {
    const ended = draw(face.cut, face, 0)
    expect(difference(ended.heights) / ended.deepest).toBeGreaterThan(2 * HEIGHT)
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
    // The second island's texels are 0.2 mm wide, twice the others' width, so the bottom of a valley falls between them.
    expect(height / deepest).toBeLessThan(0.03)
    expect(weight / 255).toBeLessThan(0.03)
  })

  test.each([0, 1, 2, 3])('filters across the cut at level %d as on uncut skin', (level) => {
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

/** Returns the maps of `autoWrinkles` for a sheet. */
function mapsOf(skin: Skin) {
  const { layers, areas } = autoWrinkles(skin, { age: 70, size: 1024, areaSize: 256 })
  return {
    heights: { ...layers[0].heights, channels: 1 },
    levels: levelsOf(layers[0].normal, 3),
    areas: areas.map(({ weights }) => ({ ...weights, channels: 1 })),
  }
}

/** Returns the UV of a point of a triangle. */
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
  /** 1 at texels covered by the skin. */
  inside: Uint8Array
  /** Depth of the valleys, millimetres, and slope of their sides, millimetres per millimetre. */
  deepest: number
  steepest: number
}

/** Cuts a face in two, with lines laid on the cut face. */
async function cutFace(path: string): Promise<CutFace> {
  const skin = await skinAt(path)
  const isRight = (triangle: number) =>
    [0, 1, 2].reduce((sum, k) => sum + skin.positions[3 * skin.indices[3 * triangle + k]], 0) < 0
  const skins = cutInTwo(skin, isRight, halfTurn)
  const prepared = prepareFace(skins.cut)
  return { ...skins, surface: prepared.surface, regions: facialCreases(prepared, AGE) }
}

/** Draws all lines on one layer. */
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

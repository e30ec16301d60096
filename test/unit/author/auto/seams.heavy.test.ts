import { AUTO_REGIONS, autoWrinkles, heightToNormal, type Skin, surfaceMetric } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { findSkin } from '../../../../packages/cli/src/auto/read-skin.ts'
import { readDocument } from '../../../../packages/cli/src/face.ts'
import type { CreasedRegion } from '../../../../packages/furrow/src/author/auto/crease.ts'
import { drawAreas, drawCreases } from '../../../../packages/furrow/src/author/auto/draw.ts'
import { findFace } from '../../../../packages/furrow/src/author/auto/face.ts'
import { faceRegions } from '../../../../packages/furrow/src/author/auto/face-regions.ts'
import { Random } from '../../../../packages/furrow/src/author/auto/random.ts'
import type { Surface } from '../../../../packages/furrow/src/author/auto/surface.ts'
import { MIP_MARGIN, SkinTexels } from '../../../../packages/furrow/src/author/auto/texels.ts'
import { type CutPlace, type CutSide, cutInTwo, findCuts, halfTurn, quarterTurn } from './cuts.ts'
import { FACES } from './faces.ts'
import { SIDE, sheet } from './sheet.ts'
import { type Channels, levelsOf, sample, slopeIn } from './slopes.ts'

const SIZE = 512
const AREA_SIZE = 128
/** 70 years: 0 at 20, 1 at 80. */
const AGE = 5 / 6

/*
 * The largest differences at a cut, as shares of the range. Beyond a cut the skin goes on as a plane for as far as texels are filtered, so
 * what may differ is what skin leaves its plane by within a texel. Here one of the layers' is 0.5 to 0.8 mm wide, and one of the areas' 2 to
 * 3 mm, while an area fades over 4 mm or more. How long a texel is, is measured by the triangles of one side; at the bridge of the nose the
 * two differ by a tenth.
 */
const HEIGHT = 0.01
const SHADE = 0.01
const WEIGHT = 0.1
const SLOPE = 0.12

/** Forehead, nose, lips, chin and neck crease across the middle; cuts that a face has of its own come on top. */
describe.each(FACES)('%s, its texture cut in two at the middle', (_, path) => {
  let made: Made
  let [whole, cut]: Drawn[] = []
  let places: CutPlace[]

  beforeAll(async () => {
    made = await make(path)
    whole = draw(made.whole, made, MIP_MARGIN)
    cut = draw(made.cut, made, MIP_MARGIN)
    places = findCuts(made.cut)
  })

  const apart = (map: Channels) =>
    largest(places, ([one, other]) => Math.abs(sample(map, one.uv) - sample(map, other.uv)))

  const slopesApart = (drawn: Drawn, level: number) =>
    largest(places, (sides) => {
      const [one, other] = sides.map((side) => slopeIn(made.cut, drawn.levels[level]!, side))
      return Math.hypot(...one!.map((value, k) => value - other![k]!))
    }) / drawn.steepest

  test('is creased at the cut', () => {
    const deepest = largest(places, ([{ uv }]) => Math.abs(sample(cut!.relief, uv)))
    expect(deepest / cut!.deepest).toBeGreaterThan(0.2)
    const steepest = largest(places, ([side]) => Math.hypot(...slopeIn(made.cut, cut!.levels[0]!, side)))
    expect(steepest / cut!.steepest).toBeGreaterThan(0.4)
  })

  test('has the same relief as uncut', () => {
    // Texels lie on the skin as they did, so there is nothing to filter.
    let off = 0
    for (let texel = 0; texel < SIZE * SIZE; texel++) {
      const [column, row] = [texel % SIZE, Math.floor(texel / SIZE)]
      const isSecond = column < SIZE * 0.475
      const same = isSecond ? (SIZE - 1 - row) * SIZE + 279 - column : texel
      if (!cut!.inside[texel] || !whole!.inside[same]) continue
      off = Math.max(off, Math.abs(cut!.relief.data[texel]! - whole!.relief.data[same]!))
    }
    expect(off / cut!.deepest).toBeLessThan(1e-4)
  })

  test('has the same height, light and areas on both sides of every cut', () => {
    const { surface } = made
    const small = { surface, texels: new SkinTexels(made.cut, surface, AREA_SIZE) }
    expect(apart(cut!.relief) / cut!.deepest).toBeLessThan(HEIGHT)
    expect(apart(cut!.occlusion) / 255).toBeLessThan(SHADE)
    for (const area of drawAreas(small, made.regions)) {
      expect(apart({ ...area, channels: 1 }) / 255).toBeLessThan(WEIGHT)
    }
  })

  test.each([0, 1, 2, 3])('has the same slopes there at level %d', (level) => {
    expect(slopesApart(cut!, level)).toBeLessThan(SLOPE)
  })

  test.each([1, 2, 3])('shows nothing of the background at level %d', (level) => {
    const off = largest(places, ([one, other]) => {
      // The first island lies where it lay.
      const side = one.uv[0] > 0.475 ? one : other
      const [own, uncut] = [cut!, whole!].map(({ levels }) => slopeIn(made.cut, levels[level]!, side))
      return Math.hypot(...own!.map((value, k) => value - uncut![k]!))
    })
    expect(off / whole!.steepest).toBeLessThan(SLOPE)
  })

  test('would have a seam if the skin ended at its islands', () => {
    const torn = draw(made.cut, made, 0)
    expect(apart(torn.relief) / torn.deepest).toBeGreaterThan(2 * HEIGHT)
    expect(slopesApart(torn, 0)).toBeGreaterThan(5 * SLOPE)
    expect(slopesApart(torn, 1)).toBeGreaterThan(2 * SLOPE)
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
    [0, 1, 2].reduce((sum, k) => sum + positions[3 * indices[3 * triangle + k]!]! / 3, 0) < SIDE / 2
  const { whole, cut } = cutInTwo(skin, isLeft, quarterTurn)
  const turned = cutInTwo(skin, () => true, quarterTurn).cut
  const [onWhole, onCut, onTurned] = [mapsOf(whole), mapsOf(cut), mapsOf(turned)]
  const deepest = onWhole.relief.data.reduce((most, height) => Math.max(most, -height), 0)
  const steepest = steepestOf(onWhole.levels[0]!)

  test('has the same wrinkles in space', () => {
    expect(onCut.areas.length).toBe(onWhole.areas.length)
    expect(onWhole.areas.length).toBeGreaterThan(0)
    const numbers = new Random(1, 'places')
    let [height, weight] = [0, 0]
    for (let triangle = 0; triangle < indices.length / 3; triangle++) {
      for (let i = 0; i < 20; i++) {
        const along = numbers.between(0, 1)
        const across = numbers.between(0, 1 - along)
        const [one, other] = [whole, cut].map((it) =>
          placeOn(it, triangle, [1 - along - across, along, across]),
        )
        height = Math.max(height, Math.abs(sample(onWhole.relief, one!) - sample(onCut.relief, other!)))
        for (const [k, area] of onWhole.areas.entries())
          weight = Math.max(weight, Math.abs(sample(area, one!) - sample(onCut.areas[k]!, other!)))
      }
    }
    // The second island's texels are 0.2 mm wide, half as fine as the others: a valley's bottom is cut off between them.
    expect(height / deepest).toBeLessThan(0.03)
    expect(weight / 255).toBeLessThan(0.03)
  })

  test.each([0, 1, 2, 3])('filters at the cut at level %d as if there were none', (level) => {
    const places = findCuts(cut)
    expect(places.length).toBeGreaterThan(0)
    const off = largest(places, ([one, other]) => {
      const sides = one.uv[0] > 0.475 ? [one, other] : [other, one]
      const differences = sides.map((side, k) => {
        const own = slopeIn(cut, onCut.levels[level]!, side)
        const uncut = slopeIn(cut, [onWhole, onTurned][k]!.levels[level]!, side)
        return Math.hypot(...own.map((value, i) => value - uncut[i]!))
      })
      return Math.max(...differences)
    })
    expect(off / steepest).toBeLessThan(0.02)
  })
})

/** What `autoWrinkles` makes of a sheet. */
function mapsOf(skin: Skin) {
  const { layers, areas } = autoWrinkles(skin, { age: 70, size: 1024, areaSize: 256 })
  return {
    relief: { ...layers[0]!.relief, channels: 1 },
    levels: levelsOf(layers[0]!.normal, 3),
    areas: areas.map(({ weights }) => ({ ...weights, channels: 1 })),
  }
}

/** Where a place of a triangle lies in the texture. */
function placeOn({ uvs, indices }: Skin, triangle: number, shares: readonly number[]): CutSide['uv'] {
  const [u, v] = [0, 1].map((k) =>
    shares.reduce((sum, share, j) => sum + share * uvs[2 * indices[3 * triangle + j]! + k]!, 0),
  )
  return [u!, v!]
}

interface Made {
  whole: Skin
  cut: Skin
  surface: Surface
  regions: CreasedRegion[]
}

interface Drawn {
  relief: Channels
  occlusion: Channels
  /** The normal map and its levels of detail. */
  levels: Channels[]
  /** 1 where the skin covers a texel. */
  inside: Uint8Array
  /** Of the valleys in millimetres, and of their sides in millimetres per millimetre. */
  deepest: number
  steepest: number
}

/** A face cut in two, in millimetres, with its lines: they are laid on the cut one. */
async function make(path: string): Promise<Made> {
  const { skin } = findSkin(await readDocument(path, 'test'), path, 'test')
  const isRight = (triangle: number) =>
    [0, 1, 2].reduce((sum, k) => sum + skin.positions[3 * skin.indices[3 * triangle + k]!]!, 0) < 0
  const skins = cutInTwo(skin, isRight, halfTurn)
  const face = findFace(skins.cut)!
  return { ...skins, surface: face.surface, regions: faceRegions(face, AGE, 1, 1, AUTO_REGIONS) }
}

/** All lines on one layer. */
function draw(skin: Skin, { surface, regions }: Made, margin: number): Drawn {
  const texels = new SkinTexels(skin, surface, SIZE, undefined, margin)
  const { relief, occlusion } = drawCreases(
    { surface, texels },
    [...new Set(regions.map(({ creases }) => creases))].flat(),
  )
  const positions = Array.from(skin.positions, (_, i) => {
    const vertex = Math.floor(i / 3)
    return surface.points[3 * surface.pointOf[vertex]! + (i % 3)]! / 1000
  })
  const metric = surfaceMetric({ ...skin, positions }, SIZE)
  const levels = levelsOf(heightToNormal(relief, metric), 3)
  return {
    relief: { ...relief, channels: 1 },
    occlusion: { ...occlusion, channels: 1 },
    levels,
    inside: metric.inside,
    deepest: relief.data.reduce((most, height) => Math.max(most, -height), 0),
    steepest: steepestOf(levels[0]!),
  }
}

function steepestOf({ data }: Channels): number {
  let most = 0
  for (let i = 0; i < data.length; i += 4) {
    const [x, y, z] = [0, 1, 2].map((k) => data[i + k]! / 127.5 - 1) as [number, number, number]
    most = Math.max(most, Math.hypot(x, y) / z)
  }
  return most
}

function largest(places: readonly CutPlace[], of: (sides: CutPlace['sides']) => number): number {
  return places.reduce((most, { sides }) => Math.max(most, of(sides)), 0)
}

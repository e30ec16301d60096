import { LINE_REGIONS } from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import { coverTexels } from '../../../../packages/furrow/src/author/cover-texels.ts'
import { skinVertices } from '../../../../packages/furrow/src/author/skin/surface.ts'
import { FACES, facialCreases, MeasuredFace } from './faces.ts'
import { type Channels, sample } from './slopes.ts'
import { shippedEars, smoothRegions, trianglesIn } from './smooth-regions.ts'

const BROWS_UP = { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 }
const BROWS_DOWN = { browDownLeft: 1, browDownRight: 1 }
const SMILE = { mouthSmileLeft: 1, mouthSmileRight: 1, cheekSquintLeft: 1, cheekSquintRight: 1 }

/**
 * Tolerances of flat skin: heights in millimetres, and normals in bytes. A height difference of 0.01 mm between texels of 0.6 mm changes the
 * normal by 2.
 */
const FLAT = 0.01
const STRAIGHT = 3

describe.each(FACES)('%s', (name, path) => {
  let measured: MeasuredFace
  /** Regions that must not have wrinkles, with their triangles. */
  let smooth: [name: string, triangles: number[]][]

  beforeAll(async () => {
    measured = await MeasuredFace.read(path)
    const { skin, face } = measured
    const regions = Object.entries(smoothRegions(face.surface))
    if (name === 'human') regions.push(['ears by the landmarks', shippedEars(skin, face.surface)])
    smooth = regions.map(([name, points]) => [name, trianglesIn(face.surface, points)])
  })

  /**
   * Tells whether a point is within 13 mm of the middle of a cheek, where fat prevents wrinkles. The middle is 6 mm outside the midpoint of the
   * outer corners of eye and mouth.
   */
  const onCheek = (x: number, y: number): boolean => {
    const { outerCorner, mouthCorner } = measured.face.landmarks
    const middle = [(outerCorner[0] + mouthCorner[0]) / 2 + 6, (outerCorner[1] + mouthCorner[1]) / 2]
    return Math.hypot(Math.abs(x) - middle[0], y - middle[1]) < 13
  }

  /** Returns the segments of the wrinkle lines in some areas. `rise` is the angle to the horizontal, degrees; `weight` is length times depth. */
  const segmentsOf = (name: RegExp) => {
    const regions = facialCreases(measured.prepared, 0.5).filter(({ region }) => name.test(region.name))
    return [...new Set(regions.flatMap(({ creases }) => creases))].flatMap(({ points, depths }) =>
      Array.from({ length: depths.length - 1 }, (_, i) => {
        const vector = [0, 1, 2].map((k) => points[3 * i + 3 + k] - points[3 * i + k])
        const length = Math.hypot(...vector)
        const rise = (Math.asin(Math.abs(vector[1]) / (length || 1)) * 180) / Math.PI
        return { rise, weight: length * depths[i], start: points.slice(3 * i, 3 * i + 3) }
      }),
    )
  }

  /** Returns the weight of the segments that satisfy a condition, as a fraction of the total weight. */
  const fractionOf = (
    all: ReturnType<typeof segmentsOf>,
    holds: (segment: (typeof all)[number]) => boolean,
  ) =>
    all.filter(holds).reduce((sum, { weight }) => sum + weight, 0) /
    all.reduce((sum, { weight }) => sum + weight, 0)

  test('has 8 to 24 areas on at most 4 layers, each driven by targets of the face', () => {
    const { areas, layers } = measured.wrinkles
    expect(areas.length).toBeGreaterThanOrEqual(8)
    expect(areas.length).toBeLessThanOrEqual(24)
    expect(layers.length).toBeLessThanOrEqual(4)
    const names = measured.skin.targets.map(({ name }) => name)
    for (const { driver } of areas) for (const { name } of driver.targets) expect(names).toContain(name)
  })

  test('has an area for every region', () => {
    const regions = measured.wrinkles.areas.map(({ name }) => name.replace(/(Left|Right)$/, ''))
    expect(new Set(regions)).toEqual(new Set(LINE_REGIONS))
  })

  test('has the left and the right area of a region on one layer', () => {
    const layerOf = new Map(measured.wrinkles.areas.map(({ name, layer }) => [name, layer]))
    for (const [name, layer] of layerOf) {
      const right = layerOf.get(name.replace(/Left$/, 'Right'))
      expect(right ?? layer, name).toBe(layer)
    }
  })

  test('creases the skin above the eyes when brows are raised', () => {
    expect(measured.activatedFraction(BROWS_UP, (_, y) => y > 0)).toBeGreaterThanOrEqual(0.85)
    expect(measured.activations(BROWS_UP).get('foreheadOuterLeft')).toBeGreaterThan(0.8)
  })

  test('has forehead lines within 20 degrees of the horizontal', () => {
    expect(fractionOf(segmentsOf(/^forehead/), ({ rise }) => rise <= 20)).toBeGreaterThanOrEqual(0.95)
  })

  test('creases vertically between the brows when they are lowered', () => {
    const innerBrow = measured.face.landmarks.innerBrow[0]
    const lines = segmentsOf(/^glabella/)
    expect(fractionOf(lines, ({ rise }) => rise >= 65)).toBeGreaterThanOrEqual(0.9)
    expect(fractionOf(lines, ({ start }) => Math.abs(start[0]) < innerBrow)).toBeGreaterThanOrEqual(0.9)
    const activations = measured.activations(BROWS_DOWN)
    for (const side of ['Left', 'Right']) expect(activations.get(`glabella${side}`)).toBeGreaterThan(0.8)
    expect(activations.get('foreheadOuterLeft')).toBe(0)
  })

  test('creases only one side if only one brow is raised', () => {
    expect(measured.activatedFraction({ browOuterUpLeft: 1 }, (x) => x < 0)).toBeLessThanOrEqual(0.03)
    expect(measured.activatedFraction({ browOuterUpRight: 1 }, (x) => x > 0)).toBeLessThanOrEqual(0.03)
  })

  test('does not crease the middle of the cheeks in a smile', () => {
    expect(measured.activatedFraction(SMILE, onCheek)).toBeLessThanOrEqual(0.05)
    expect(measured.activations(SMILE).get('nasolabialLeft')).toBeGreaterThan(0.5)
    expect(measured.activations(SMILE).get('crowsFeetLeft')).toBeGreaterThan(0.5)
  })

  test('creases neither forehead nor cheeks when the jaw opens', () => {
    const smiled = measured.activated(SMILE, () => true)
    expect(measured.activated({ jawOpen: 1 }, (_, y) => y > 5) / smiled).toBeLessThan(0.005)
    expect(measured.activated({ jawOpen: 1 }, onCheek) / smiled).toBeLessThan(0.005)
  })

  /** Returns the largest deviation of a map's channel from `flat`, at corners and centroids of triangles. */
  const deviation = (map: Channels, triangles: readonly number[], flat: number, channel = 0) => {
    const { skin, face } = measured
    let most = 0
    for (const triangle of triangles) {
      const corners = skinVertices(skin, face.surface, triangle).map((i) => [
        skin.uvs[2 * i],
        skin.uvs[2 * i + 1],
      ])
      const middle = [0, 1].map((k) => corners.reduce((sum, uv) => sum + uv[k] / 3, 0))
      for (const [u, v] of [...corners, middle])
        most = Math.max(most, Math.abs(sample(map, [u, v], channel) - flat))
    }
    return most
  }

  /** Returns the largest deviations of layers with lines from flat skin: heights in millimetres, normals and occlusion in bytes. */
  const deviations = (triangles: readonly number[]) => {
    const layers = measured.wrinkles.layers.filter(({ onset }) => onset)
    return {
      heights: Math.max(...layers.map(({ heights }) => deviation({ ...heights, channels: 1 }, triangles, 0))),
      normal: Math.max(
        ...layers.flatMap(({ normal }) =>
          [0, 1].map((k) => deviation({ ...normal, channels: 4 }, triangles, 128, k)),
        ),
      ),
      shade: Math.max(
        ...layers.map(({ occlusion }) => deviation({ ...occlusion, channels: 1 }, triangles, 255)),
      ),
    }
  }

  /** Returns the largest weight of all areas on some triangles, and the number of texels that the triangles cover. */
  const weights = (triangles: readonly number[]) => {
    const { skin, face, wrinkles } = measured
    const { width, height } = wrinkles.areas[0].weights
    let [most, count] = [0, 0]
    for (const triangle of triangles) {
      const vertices = skinVertices(skin, face.surface, triangle)
      coverTexels(skin.uvs, vertices, width, height, (texel) => {
        count++
        for (const { weights } of wrinkles.areas) most = Math.max(most, weights.data[texel])
      })
    }
    return { most, count }
  }

  test('creases nothing on eyes, inside lips, or on ears', () => {
    const everywhere = deviations([...measured.face.surface.skinTriangles.keys()])
    expect(everywhere.heights).toBeGreaterThan(1)
    expect(everywhere.normal).toBeGreaterThan(80)
    for (const [name, triangles] of smooth) {
      expect(triangles.length, name).toBeGreaterThan(150)
      const { heights, normal, shade } = deviations(triangles)
      expect(heights, name).toBeLessThan(FLAT)
      expect(normal, name).toBeLessThan(STRAIGHT)
      // 1 of 255 steps is rounding; 2 steps cannot be seen.
      expect(shade, name).toBeLessThan(2)
    }
  })

  test('has no area on eyes, inside lips, or on ears', () => {
    expect(weights([...measured.face.surface.skinTriangles.keys()]).most).toBe(255)
    for (const [name, triangles] of smooth) {
      const { most, count } = weights(triangles)
      expect(count, name).toBeGreaterThan(10)
      expect(most, name).toBe(0)
    }
  })

  test('raises eyes, lips and ears by less than half a millimetre with age', () => {
    const { layers, bulges } = measured.wrinkles
    const { heights } = layers[bulges[0].layer]
    for (const { weights } of bulges) {
      const data = heights.data.map((height, i) => {
        const [u, v] = [(i % heights.width) / heights.width, Math.floor(i / heights.width) / heights.height]
        return (height * sample({ ...weights, channels: 1 }, [u, v], 0)) / 255
      })
      const raised = { ...heights, data, channels: 1 }
      for (const [name, triangles] of smooth) expect(deviation(raised, triangles, 0), name).toBeLessThan(0.5)
    }
  })

  test('has drivers whose activation differs by less than 0.2 from the correct one, on average', () => {
    const errors = measured.wrinkles.areas.map(({ error }) => error)
    expect(errors.reduce((a, b) => a + b, 0) / errors.length).toBeLessThan(0.2)
    expect(Math.max(...errors)).toBeLessThan(0.5)
  })
})

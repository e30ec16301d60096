import { AUTO_REGIONS } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { faceRegions } from '../../../../packages/furrow/src/author/auto/face-regions.ts'
import { hasScan } from '../../../real-face/pack-scan.ts'
import { FACES, Measured } from './faces.ts'

const BROWS_UP = { browInnerUp: 1, browOuterUpLeft: 1, browOuterUpRight: 1 }
const BROWS_DOWN = { browDownLeft: 1, browDownRight: 1 }
const SMILE = { mouthSmileLeft: 1, mouthSmileRight: 1, cheekSquintLeft: 1, cheekSquintRight: 1 }

if (!hasScan) {
  test.skip('the scanned face is not at hand: automatic wrinkles are tested on the shipped one alone', () => {})
}

describe.each(FACES)('%s', (_, path) => {
  let measured: Measured

  beforeAll(async () => {
    measured = await Measured.read(path)
  })

  /** The middle of each cheek: between the outer corner of the eye and that of the mouth, where fat lies. */
  const onCheek = (x: number, y: number): boolean => {
    const { outerCorner, mouthCorner } = measured.face.landmarks
    const middle = [(outerCorner[0] + mouthCorner[0]) / 2 + 6, (outerCorner[1] + mouthCorner[1]) / 2]
    return Math.hypot(Math.abs(x) - middle[0], y - middle[1]) < 13
  }

  /** Of the lines of some areas, each piece's length and how steeply it rises, in degrees. */
  const pieces = (name: RegExp) => {
    const regions = faceRegions(measured.face, 0.5, 1, 1, AUTO_REGIONS).filter(({ region }) =>
      name.test(region.name),
    )
    return [...new Set(regions.flatMap(({ creases }) => creases))].flatMap(({ points, depths }) =>
      Array.from({ length: depths.length - 1 }, (_, i) => {
        const way = [0, 1, 2].map((k) => points[3 * i + 3 + k]! - points[3 * i + k]!)
        const length = Math.hypot(...way)
        const rise = (Math.asin(Math.abs(way[1]!) / (length || 1)) * 180) / Math.PI
        return { rise, weight: length * depths[i]!, at: points.slice(3 * i, 3 * i + 3) }
      }),
    )
  }

  /** The share of the lines, by length and depth, for which something holds. */
  const shareOf = (all: ReturnType<typeof pieces>, holds: (piece: (typeof all)[number]) => boolean) =>
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

  test('has an area of every region', () => {
    const regions = measured.wrinkles.areas.map(({ name }) => name.replace(/(Left|Right)$/, ''))
    expect(new Set(regions)).toEqual(new Set(AUTO_REGIONS))
  })

  test('left and right lie on one layer', () => {
    const layerOf = new Map(measured.wrinkles.areas.map(({ name, layer }) => [name, layer]))
    for (const [name, layer] of layerOf) {
      const right = layerOf.get(name.replace(/Left$/, 'Right'))
      expect(right ?? layer, name).toBe(layer)
    }
  })

  test('raised brows crease what lies above the eyes', () => {
    expect(measured.share(BROWS_UP, (_, y) => y > 0)).toBeGreaterThanOrEqual(0.85)
    expect(measured.activations(BROWS_UP).get('foreheadOuterLeft')).toBeGreaterThan(0.8)
  })

  test('lines of the forehead run within 20 degrees of the horizontal', () => {
    expect(shareOf(pieces(/^forehead/), ({ rise }) => rise <= 20)).toBeGreaterThanOrEqual(0.95)
  })

  test('lowered brows crease upright lines between them', () => {
    const between = measured.face.landmarks.innerBrow[0]
    const lines = pieces(/^glabella/)
    expect(shareOf(lines, ({ rise }) => rise >= 65)).toBeGreaterThanOrEqual(0.9)
    expect(shareOf(lines, ({ at }) => Math.abs(at[0]!) < between)).toBeGreaterThanOrEqual(0.9)
    const activations = measured.activations(BROWS_DOWN)
    for (const side of ['Left', 'Right']) expect(activations.get(`glabella${side}`)).toBeGreaterThan(0.8)
    expect(activations.get('foreheadOuterLeft')).toBe(0)
  })

  test('one raised brow leaves the other side alone', () => {
    expect(measured.share({ browOuterUpLeft: 1 }, (x) => x < 0)).toBeLessThanOrEqual(0.03)
    expect(measured.share({ browOuterUpRight: 1 }, (x) => x > 0)).toBeLessThanOrEqual(0.03)
  })

  test('a smile does not crease the middle of the cheeks', () => {
    expect(measured.share(SMILE, onCheek)).toBeLessThanOrEqual(0.05)
    expect(measured.activations(SMILE).get('nasolabialLeft')).toBeGreaterThan(0.5)
    expect(measured.activations(SMILE).get('crowsFeetLeft')).toBeGreaterThan(0.5)
  })

  test('an opened jaw creases neither forehead nor cheeks', () => {
    const smiled = measured.activated(SMILE, () => true)
    expect(measured.activated({ jawOpen: 1 }, (_, y) => y > 5) / smiled).toBeLessThan(0.005)
    expect(measured.activated({ jawOpen: 1 }, onCheek) / smiled).toBeLessThan(0.005)
  })

  test('drivers follow what was measured', () => {
    const errors = measured.wrinkles.areas.map(({ error }) => error)
    expect(errors.reduce((a, b) => a + b, 0) / errors.length).toBeLessThan(0.2)
    expect(Math.max(...errors)).toBeLessThan(0.5)
  })
})

import { existsSync, readFileSync } from 'node:fs'
import { parseWrinkleSetDocument } from 'furrow'
import {
  type AutoOptions,
  type AutoWrinkles,
  autoWrinkles,
  type GrayImage,
  paintAreas,
  parseStrokes,
  StrokeLayer,
  type StrokesDocument,
  skinCanvas,
  strokesToHeight,
} from 'furrow/author'
import {
  BLOOD_AMPLITUDE,
  halfSide,
  heightLevels,
  strokesOf,
  surfaceMetric,
  valleyBlood,
} from 'furrow/internal'
import { findSkin } from 'furrow-files'
import { decodeNormalMap, readDocument, readFaceMesh } from 'furrow-files/node'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'

const faces = new URL('../../../faces/', import.meta.url)
const path = (name: string) => new URL(name, faces).pathname
const json = (name: string): unknown => JSON.parse(readFileSync(path(name), 'utf8'))
const strokes = (): StrokesDocument => parseStrokes(json('human/drawn.json'))

const both = (name: string) => [`${name}Left`, `${name}Right`]
const DRAWN = [...both('forehead'), 'glabella', 'nose']
const MADE = [...both('crowsFeet'), ...both('nasolabial'), ...both('underEye'), 'upperLip', 'lowerLip']
const AREAS = [...DRAWN, ...MADE]

/** Options that the command in faces/human/README.md has. */
const OPTIONS = {
  age: 50,
  strength: 1.3,
  layers: 1,
  frame: 'orthonormal',
  regions: ['glabella', 'nose', 'crowsFeet', 'nasolabial', 'underEye', 'upperLip', 'lowerLip'],
} as const satisfies AutoOptions

/** Returns the weights of a committed area, where 255 is fully visible. */
async function committed(name: string, face = 'human'): Promise<Uint8Array> {
  const { width, height, data } = await grayOf(`${face}/areas/${name}.png`)
  expect([width, height]).toEqual([128, 128])
  return data.map((gray) => 255 - gray)
}

async function grayOf(file: string): Promise<GrayImage> {
  const { data, info } = await sharp(path(file))
    .toColourspace('b-w')
    .raw()
    .toBuffer({ resolveWithObject: true })
  expect(info.channels).toBe(1)
  return { width: info.width, height: info.height, data: new Uint8Array(data) }
}

const largestDifference = (a: Uint8Array, b: Uint8Array) =>
  a.reduce((worst, value, i) => Math.max(worst, Math.abs(value - b[i])), 0)

const FACES = ['human', 'human-2'].filter((name) => existsSync(path(`${name}/wrinkles.json`)))

describe.each(FACES)('faces/%s', (name) => {
  const set = parseWrinkleSetDocument(json(`${name}/wrinkles.json`))
  const [layer] = set.layers
  let made: AutoWrinkles
  /** Strokes document: computed strokes, and hand-drawn ones at glabella and nose. */
  let document: StrokesDocument
  let lines: StrokeLayer

  beforeAll(async () => {
    const { skin } = findSkin(await readDocument(path(`${name}.glb`), 'test'), name, 'test')
    made = autoWrinkles(skin, OPTIONS)
    const kept = strokesOf(made).strokes.filter(({ group }) => !/^(glabella|nose)(Left|Right)$/.test(group!))
    document = { ...strokesOf(made), strokes: [...kept, ...strokes().strokes] }
    const { mesh } = await readFaceMesh(path(`${name}.glb`), 'test')
    lines = new StrokeLayer(skinCanvas(mesh, 1024, 1024, made.scale), { frame: OPTIONS.frame })
    lines.draw(document.strokes)
  })

  it('is a wrinkle set of twelve areas whose files exist', () => {
    expect(set.areas.map((area) => area.name)).toEqual(AREAS)
    for (const address of [...set.areas.map((area) => area.image), layer.normal]) {
      expect(existsSync(path(`${name}/${address}`)), address).toBe(true)
    }
  })

  it('has the areas computed from its blendshapes, up to rounding', async () => {
    for (const { name: area, weights } of made.areas) {
      if (!MADE.includes(area)) continue
      expect(largestDifference(await committed(area, name), weights.data), area).toBeLessThanOrEqual(1)
    }
  })

  it('has the strokes computed from its blendshapes, and the hand-drawn ones', () => {
    const stored = parseStrokes(json(`${name}/strokes.json`))
    expect(stored.scale).toBeCloseTo(made.scale, 3)
    expect(stored.strokes.map(({ group, points }) => [group, points.length])).toEqual(
      document.strokes.map(({ group, points }) => [group, points.length]),
    )
  })

  it('has normals and occlusion of its strokes, up to rounding', async () => {
    const file = path(`${name}/layers/expression/normal.png`)
    const shipped = await decodeNormalMap(readFileSync(file), file, 'test')
    expect(largestDifference(shipped.data, lines.normal.data)).toBeLessThanOrEqual(1)
    const occlusion = await grayOf(`${name}/layers/expression/occlusion.png`)
    expect(largestDifference(occlusion.data, halfSide(lines.occlusion).data)).toBeLessThanOrEqual(1)
  })

  it('has the heights of its strokes, for relief', async () => {
    const { levels, amplitude } = heightLevels(lines.heights.data)
    expect(layer.heightAmplitude).toBeCloseTo(amplitude, 6)
    const heights = await grayOf(`${name}/layers/expression/height.png`)
    expect(
      largestDifference(heights.data, halfSide({ ...lines.heights, data: levels }).data),
    ).toBeLessThanOrEqual(1)
  })

  it('has darker skin in valleys', async () => {
    const { width, height, data } = lines.heights
    const { levels, amplitude } = heightLevels(data)
    const half = halfSide({ width, height, data: levels })
    const expected = valleyBlood({
      ...half,
      data: Float32Array.from(half.data, (b) => 1000 * amplitude * (b / 255 - 0.5)),
    })
    const shipped = await grayOf(`${name}/layers/expression/blood.png`)
    expect(largestDifference(shipped.data, expected.data)).toBeLessThanOrEqual(1)
    expect(layer.bloodAmplitude).toBe(BLOOD_AMPLITUDE)
  })
})

describe('shipped areas', () => {
  it('equal those painted from their strokes document, up to rounding', async () => {
    const { mesh } = await readFaceMesh(path('human.glb'), 'test')
    const painted = paintAreas(strokes(), skinCanvas(mesh, 128))
    expect(painted.map((area) => area.name)).toEqual(DRAWN)
    for (const { name, weights } of painted) {
      expect(largestDifference(await committed(name), weights.data), name).toBeLessThanOrEqual(1)
    }
  })

  it('stay on their side of the face', async () => {
    for (const name of AREAS) {
      const weights = await committed(name)
      // Areas of both sides blend over 14 mm at the middle of the forehead. Half of that is less than 0.02 of the texture.
      for (let i = 0; i < weights.length; i++) {
        const u = ((i % 128) + 0.5) / 128
        if (name.endsWith('Left') && u < 0.475) expect(weights[i], name).toBe(0)
        if (name.endsWith('Right') && u > 0.525) expect(weights[i], name).toBe(0)
      }
      expect(Math.max(...weights), name).toBe(255)
    }
  })

  it('leave out the openings of the eyes', async () => {
    const { mesh } = await readFaceMesh(path('human.glb'), 'test')
    const { inside } = surfaceMetric(mesh, 128)
    const openings = [...inside.keys()].filter((i) => {
      const [u, v] = [(i % 128) / 128, Math.floor(i / 128) / 128]
      return inside[i] === 0 && v > 0.48 && v < 0.56 && Math.abs(u - 0.5) < 0.15
    })
    expect(openings.length).toBeGreaterThan(20)
    for (const name of AREAS) {
      const weights = await committed(name)
      for (const i of openings) expect(weights[i], name).toBe(0)
    }
  })

  it('of the left and right forehead sum to 1 at the middle', async () => {
    const [left, right] = [await committed('foreheadLeft'), await committed('foreheadRight')]
    for (let y = Math.round(0.3 * 128); y < 0.39 * 128; y++) {
      for (let x = 60; x < 68; x++) {
        expect(Math.abs(left[y * 128 + x] + right[y * 128 + x] - 255)).toBeLessThanOrEqual(2)
      }
      expect(left[y * 128 + 63]).toBeGreaterThan(64)
      expect(right[y * 128 + 63]).toBeGreaterThan(64)
    }
  })

  it('cover every stroke and every height', async () => {
    const total = new Float64Array(128 * 128)
    for (const name of AREAS) {
      const weights = await committed(name)
      for (let i = 0; i < weights.length; i++) total[i] += weights[i]
    }
    const { mesh } = await readFaceMesh(path('human.glb'), 'test')
    const { data } = strokesToHeight(strokes().strokes, skinCanvas(mesh, 128))
    let drawn = 0
    for (let i = 0; i < data.length; i++) {
      if (data[i] > -0.07) continue
      drawn++
      expect(total[i], `texel ${i % 128}, ${Math.floor(i / 128)}`).toBeGreaterThan(0.9 * 255)
    }
    expect(drawn).toBeGreaterThan(150)
  })
})

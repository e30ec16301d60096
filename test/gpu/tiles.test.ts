import type { RgbaImage } from 'furrow'
import { reference } from 'furrow/internal'
import {
  AmbientLight,
  DataTexture,
  DirectionalLight,
  LinearFilter,
  MeshLambertMaterial,
  RepeatWrapping,
  Scene,
} from 'three'
import { describe, expect, it } from 'vitest'
import { randomImage, randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

const MAP = 16
const PIXELS = 64
/** Scale and offset of texture coordinates that float32 represents exactly in all tested tiles. */
const [SCALE, START] = [0.875, 0.0625]
const TILES = [
  [1, -1],
  [-3, 2],
]

describe.each(RENDERERS)('skin in another UV tile on %s', (name) => {
  const harness = harnessOn(name)

  it.each([
    ['default', true],
    ['default', false],
    ['composed', true],
    ['composed', false],
    ['paper', true],
  ] as const)('is drawn as in the first tile, in the mode %s (own normal map: %s)', async (mode, hasMap) => {
    const first = await draw(harness, mode, hasMap, [0, 0])
    expect(new Set(first).size).toBeGreaterThan(50)
    for (const tile of TILES) expect(await draw(harness, mode, hasMap, tile)).toEqual(first)
  })

  it('has the same influence', async () => {
    for (const mode of ['default', 'paper'] as const) {
      const first = await draw(harness, mode, true, [0, 0], true)
      expect(new Set(first).size).toBeGreaterThan(50)
      for (const tile of TILES) expect(await draw(harness, mode, true, tile, true)).toEqual(first)
    }
  })
})

it.each(RENDERERS)(
  'a normal map that the page moves into another tile looks the same on %s',
  async (name) => {
    const harness = await createHarness(name)
    const normals = repeating(randomNormals(seeded(20), MAP))
    const mesh = square(new MeshLambertMaterial({ normalMap: normals }), SCALE, [START, START])
    const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(4), 6, MAP, MAP), { areaSize: MAP })
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.7)
    const light = new DirectionalLight()
    light.position.set(0.4, 0.3, 1)
    const scene = new Scene().add(mesh, light)
    const picture = async () => (await harness.renderBytes(scene, squareCamera(), PIXELS)).slice()
    const first = await picture()
    expect(new Set(first).size).toBeGreaterThan(30)
    normals.offset.set(1, -2)
    // three.js applies a changed texture transform only in the next frame.
    await picture()
    expect(await picture()).toEqual(first)
    wrinkles.dispose()
    harness.dispose()
  },
)

it.each(RENDERERS)(
  'a mesh that crosses tiles has no seam on %s, even if another mesh of the face lies in one tile',
  async (name) => {
    const harness = await createHarness(name)
    const pictures = []
    for (const scale of [2, 0.5]) {
      const material = new MeshLambertMaterial()
      const [first, second] = [square(material, scale, [0.1, 0.1]), square(material, 1, [0.3, 0.31])]
      second.position.z = 1
      const light = new DirectionalLight()
      light.position.set(1, 1, 1)
      const wrinkles = new harness.Wrinkles(first, randomSet(seeded(4), 6, MAP, PIXELS), { areaSize: MAP })
      for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.7)
      wrinkles.addMesh(second)
      pictures.push(await harness.renderBytes(new Scene().add(first, second, light), squareCamera(), 65))
      wrinkles.dispose()
    }
    expect(new Set(pictures[0]).size).toBeGreaterThan(50)
    expect(largestDifference(pictures[0], pictures[1])).toBe(0)
    harness.dispose()
  },
)

it('coordinates in 0..1, including both ends, do not repeat', () => {
  const array = { width: 4, height: 1, depth: 1, channels: 1, data: Uint8Array.of(10, 90, 170, 250) } as const
  const at = (u: number) => 255 * reference.sampleArray(array, u, 0.5, 0)
  expect([at(0), at(1)]).toEqual([10, 250])
  for (const u of [0.1, 0.375, 0.9])
    for (const tile of [-2, -1, 1, 3]) expect(at(u + tile)).toBeCloseTo(at(u), 9)
})

/** Renders a lit square with random maps and areas. */
async function draw(
  harness: Harness,
  mode: 'default' | 'composed' | 'paper',
  hasMap: boolean,
  tile: readonly number[],
  influence = false,
): Promise<Uint8Array> {
  const random = seeded(20)
  const set = randomSet(random, 12, MAP, MAP)
  const [colour, normals] = [repeating(randomImage(random, MAP)), repeating(randomNormals(random, MAP))]
  const material = new MeshLambertMaterial({ map: colour, ...(hasMap && { normalMap: normals }) })
  const mesh = square(
    material,
    SCALE,
    tile.map((origin) => origin + START),
  )
  const wrinkles = new harness.Wrinkles(mesh, set, { mode, areaSize: MAP })
  for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.2 * random())
  if (influence) mesh.material = wrinkles.createInfluenceMaterial()
  const scene = new Scene()
  const light = new DirectionalLight(0xffffff, 2)
  light.position.set(0.4, 0.3, 1)
  scene.add(mesh, light, new AmbientLight(0xffffff, 0.3))
  const pixels = await harness.renderBytes(scene, squareCamera(), PIXELS)
  wrinkles.dispose()
  for (const resource of [colour, normals, material, mesh.geometry]) resource.dispose()
  return pixels
}

function repeating({ data, width, height }: RgbaImage): DataTexture {
  const texture = new DataTexture(data, width, height)
  texture.wrapS = texture.wrapT = RepeatWrapping
  texture.minFilter = texture.magFilter = LinearFilter
  texture.needsUpdate = true
  return texture
}

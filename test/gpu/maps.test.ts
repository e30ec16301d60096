import { packColours, packGrays, reference } from 'furrow/internal'
import {
  AmbientLight,
  DataTexture,
  DirectionalLight,
  FloatType,
  LinearFilter,
  MeshPhongMaterial,
  MeshStandardMaterial,
  Scene,
  SRGBColorSpace,
} from 'three'
import { describe, expect, it } from 'vitest'
import { randomAreas, randomImage } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference, STEP } from './difference.ts'
import { type Harness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { influenceAt } from './influence-at.ts'
import { colourAt, KINDS, type Kind, LAYERS, layerValue, MAP, randomLayer } from './layer-values.ts'

const PIXELS = 32
describe.each(RENDERERS)("the layers' other maps on %s", (name) => {
  const harness = harnessOn(name)

  describe.each([
    ['with maps of its own', true],
    ['without', false],
  ])('on a material %s', (_, hasMaps) => {
    it.each(LAYERS.map((layers) => [layers]))('are mixed as in the reference: %j', async (layers) => {
      const random = seeded(23)
      for (let i = 0; i < 3; i++) {
        const { shown, exact, plain } = await compare(harness, random, layers, hasMaps)
        expect(largestDifference(shown, exact)).toBeLessThanOrEqual(2 * STEP)
        // The maps must change the picture by several times the tolerance.
        expect(largestDifference(plain, exact)).toBeGreaterThan(8 / 255)
      }
    })
  })

  it('are mixed into maps that the page adds or removes later', async () => {
    const random = seeded(29)
    const layers = [randomLayer(random, 'layer', KINDS)]
    const areas = randomAreas(random, 12, MAP).map((area) => ({ ...area, layer: 'layer' }))
    const map = linearTexture(randomImage(random, MAP))
    const rest = linearTexture(randomImage(random, MAP))
    const own = { map, roughnessMap: rest, aoMap: rest }
    const none = { map: null, roughnessMap: null, aoMap: null }
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(0.3, 0.2, 1)
    const scene = new Scene().add(light, new AmbientLight(0xffffff, 1.5))
    const show = (maps: typeof own | typeof none) => {
      const material = new MeshStandardMaterial({ roughness: 0.8, ...maps })
      const mesh = square(material, 0.8, [0.1, 0.1])
      const wrinkles = new harness.Wrinkles(mesh, { layers, areas }, { areaSize: MAP })
      for (const [i, { name }] of areas.entries()) wrinkles.setActivation(name, (0.2 * i) / areas.length)
      return { mesh, material, wrinkles }
    }
    const pictureOf = async ({ mesh }: ReturnType<typeof show>) => {
      scene.add(mesh)
      const picture = (await harness.render(scene, squareCamera(), PIXELS)).slice()
      scene.remove(mesh)
      return picture
    }
    const faces = [show(own), show(none)] as const
    const [mapped, bare] = [await pictureOf(faces[0]), await pictureOf(faces[1])]
    expect(largestDifference(mapped, bare)).toBeGreaterThan(8 / 255)
    for (const [i, other, wanted] of [
      [0, none, bare],
      [1, own, mapped],
      [0, own, mapped],
    ] as const) {
      Object.assign(faces[i].material, other)
      faces[i].material.needsUpdate = true
      expect(largestDifference(await pictureOf(faces[i]), wanted)).toBeLessThan(1e-6)
    }
    for (const { wrinkles, mesh } of faces) {
      wrinkles.dispose()
      mesh.geometry.dispose()
    }
  })
})

describe.each(RENDERERS)('highlights of lights on %s', (name) => {
  const harness = harnessOn(name)

  it.each([
    ['physical', () => new MeshStandardMaterial({ roughness: 0.9, metalness: 1 })],
    ['Phong', () => new MeshPhongMaterial({ color: 0, specular: 0xffffff, shininess: 2 })],
  ])('are shadowed in valleys of a %s material, as in the reference', async (_, create) => {
    const random = seeded(31)
    for (let i = 0; i < 3; i++) {
      const own = randomLayer(random, 'layer', ['occlusion'])
      const areas = randomAreas(random, 12, MAP).map((area) => ({ ...area, layer: 'layer' }))
      const mesh = square(create(), 0.8, [0.1, 0.1])
      const wrinkles = new harness.Wrinkles(
        mesh,
        { layers: [{ ...own, occlusionStrength: 1 }], areas },
        { areaSize: MAP },
      )
      const scene = new Scene()
      const light = new DirectionalLight(0xffffff, 8)
      light.position.set(0.8, 0.1, 0.5)
      scene.add(mesh, light)
      const plain = await harness.render(scene, squareCamera(), PIXELS)
      for (const { name } of areas) wrinkles.setActivation(name, random())
      const shown = await harness.render(scene, squareCamera(), PIXELS)
      const activations = areas.map(({ name }) => wrinkles.getActivation(name))
      const influenceOf = influenceAt(areas, activations, MAP)
      const cosine = light.position.z / light.position.length()
      const exact = plain.slice()
      for (let pixel = 0; pixel < PIXELS * PIXELS; pixel++) {
        const u = (((pixel % PIXELS) + 0.5) / PIXELS) * 0.8 + 0.1
        const v = (1 - (Math.floor(pixel / PIXELS) + 0.5) / PIXELS) * 0.8 + 0.1
        const value = [reference.sampleArray(packGrays([own.occlusion!]), u, v, 0)]
        const [visibility] = reference.mixValues([1], [{ value, influence: influenceOf(u, v) }])
        const shadow = reference.microShadow(visibility, cosine)
        for (let c = 0; c < 3; c++) exact[4 * pixel + c] *= shadow
      }
      expect(largestDifference(shown, exact)).toBeLessThanOrEqual(2 * STEP)
      expect(largestDifference(plain, exact)).toBeGreaterThan(8 / 255)
      wrinkles.dispose()
      mesh.geometry.dispose()
    }
  })
})

/** Renders wrinkles, wrinkles at rest, and a plain material whose maps contain the mixture computed in float64. */
async function compare(harness: Harness, random: () => number, kinds: Kind[][], hasMaps: boolean) {
  const layers = kinds.map((ofLayer, i) => randomLayer(random, `layer${i}`, ofLayer))
  const areas = randomAreas(random, 12, MAP).map((area, i) => ({
    ...area,
    layer: `layer${i % layers.length}`,
  }))
  const own = { baseColor: randomImage(random, MAP), rest: randomImage(random, MAP) }
  const material = new MeshStandardMaterial({ roughness: 0.8, color: 0xd0e0f0, aoMapIntensity: 0.7 })
  if (hasMaps) {
    material.map = linearTexture(own.baseColor)
    material.map.colorSpace = SRGBColorSpace
    material.roughnessMap = material.aoMap = linearTexture(own.rest)
  }
  const mesh = square(material, 0.8, [0.1, 0.1])
  const wrinkles = new harness.Wrinkles(mesh, { layers, areas }, { areaSize: MAP })
  const scene = new Scene()
  const light = new DirectionalLight(0xffffff, 2)
  light.position.set(0.3, 0.2, 1)
  scene.add(mesh, light, new AmbientLight(0xffffff, 1.5))
  const plain = await harness.render(scene, squareCamera(), PIXELS)
  for (const { name } of areas) wrinkles.setActivation(name, random() * 0.6)
  const shown = await harness.render(scene, squareCamera(), PIXELS)

  const activations = areas.map(({ name }) => wrinkles.getActivation(name))
  const names = layers.map(({ name }) => name)
  const influence = influenceAt(areas, activations, MAP, names)
  const mixed = (kind: Kind) => (u: number, v: number) =>
    reference.mixValues(
      ownValue(kind, hasMaps ? own : null, u, v),
      layers.flatMap((layer, i) =>
        layer[kind] ? [{ value: layerValue(layer, kind, u, v), influence: influence(u, v, i) }] : [],
      ),
    )
  wrinkles.dispose()
  const exactMaterial = material.clone()
  const blood = mixed('blood')
  const colour = mixed('baseColor')
  exactMaterial.map = pictureOf((u, v) => reference.bloodColour(colour(u, v), blood(u, v)[0]))
  exactMaterial.roughnessMap = pictureOf(mixed('roughness'))
  // The material's `aoMapIntensity` applies only to its own map. A layer has a separate strength.
  if (!hasMaps) exactMaterial.aoMapIntensity = 1
  exactMaterial.aoMap = pictureOf(mixed('occlusion'))
  mesh.material = exactMaterial
  const exact = await harness.render(scene, squareCamera(), PIXELS)
  mesh.geometry.dispose()
  return { shown, exact, plain }
}

function ownValue(
  kind: Kind,
  own: Record<'baseColor' | 'rest', ReturnType<typeof randomImage>> | null,
  u: number,
  v: number,
) {
  if (kind === 'blood') return [0]
  if (!own) return kind === 'baseColor' ? [1, 1, 1] : [1]
  if (kind === 'baseColor') return colourAt(own.baseColor, u, v)
  return [reference.sampleArray(packColours([own.rest]), u, v, 0, kind === 'roughness' ? 1 : 0)]
}

function linearTexture(image: ReturnType<typeof randomImage>): DataTexture {
  const map = new DataTexture(image.data, MAP, MAP)
  map.minFilter = map.magFilter = LinearFilter
  map.needsUpdate = true
  return map
}

/** Creates a texture with one texel per pixel of the picture. A single number fills all channels. */
function pictureOf(at: (u: number, v: number) => number[]): DataTexture {
  const data = new Float32Array(PIXELS * PIXELS * 4).fill(1)
  for (let i = 0; i < PIXELS * PIXELS; i++) {
    const [x, y] = [(i % PIXELS) + 0.5, Math.floor(i / PIXELS) + 0.5]
    const value = at((x / PIXELS) * 0.8 + 0.1, (1 - y / PIXELS) * 0.8 + 0.1)
    data.set(value.length === 1 ? [...value, ...value, ...value] : value, 4 * i)
  }
  const map = new DataTexture(data, PIXELS, PIXELS, undefined, FloatType)
  // Undoes the transform of the square's texture coordinates, so that each texel covers one pixel.
  map.matrixAutoUpdate = false
  map.matrix.set(1 / 0.8, 0, -0.125, 0, -1 / 0.8, 1.125, 0, 0, 1)
  map.needsUpdate = true
  return map
}

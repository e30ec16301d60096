import { Constants } from '@babylonjs/core/Engines/constants.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js'
import { Color3 } from '@babylonjs/core/Maths/math.color.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { ToHalfFloat } from '@babylonjs/core/Misc/textureTools.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { RgbaImage } from 'furrow'
import { Wrinkles } from 'furrow/babylon'
import { packColours, packGrays, reference } from 'furrow/internal'
import { afterEach, describe, expect, it } from 'vitest'
import { randomAreas, randomImage } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { influenceAt } from '../influence-at.ts'
import { colourAt, type Kind, LAYERS, layerValue, linear, MAP, randomLayer } from '../layer-values.ts'
import { type BabylonHarness, ENGINES, harnessOn, square } from './harness.ts'

const PIXELS = 32

/** Debug modes of Babylon.js that show roughness and occlusion. */
const SHOW = { roughness: 63, occlusion: 89 }

describe.each(ENGINES)("the layers' other maps in Babylon.js on %s", (name) => {
  const harness = harnessOn(name)
  afterEach(() => expect(harness.errors).toEqual([]))

  describe.each([
    ['with maps of its own', true],
    ['without', false],
  ])('on a material %s', (_, hasMaps) => {
    it.each(LAYERS.map((layers) => [layers]))('are mixed as in the reference: %j', async (layers) => {
      const random = seeded(23)
      for (const kind of ['colour', 'roughness', 'occlusion'] as const) {
        if (
          !layers
            .flat()
            .some((own) => own === kind || (kind === 'colour' && (own === 'baseColor' || own === 'blood')))
        )
          continue
        const { error, effect } = await compare(
          harness,
          random,
          layers,
          kind,
          hasMaps ? physicalWithMaps : physical,
        )
        expect(error, kind).toBeLessThanOrEqual(2 / 255)
        expect(effect, `the effect on ${kind}`).toBeGreaterThan(8 / 255)
      }
    })
  })

  it.each([
    ['with maps of its own', standardWithMaps],
    ['without', standard],
  ])('are mixed into the colour of a StandardMaterial %s', async (_, create) => {
    const random = seeded(24)
    for (const layers of [
      [['baseColor']],
      [['blood']],
      [['baseColor', 'blood'], ['occlusion']],
    ] as Kind[][][]) {
      const { error, effect } = await compare(harness, random, layers, 'colour', create)
      expect(error).toBeLessThanOrEqual(2 / 255)
      expect(effect).toBeGreaterThan(8 / 255)
    }
  })

  it('darken highlights in valleys and leave diffuse light unchanged', async () => {
    const random = seeded(31)
    const scene = harness.createScene()
    const own = { ...randomLayer(random, 'layer', ['occlusion']), occlusionStrength: 1 }
    const areas = randomAreas(random, 12, MAP)
    const material = new PBRMaterial('skin', scene)
    const light = new DirectionalLight('light', new Vector3(-0.8, -0.1, 0.5), scene)
    light.intensity = 8
    const mesh = square(scene)
    mesh.material = material
    const wrinkles = new Wrinkles(mesh, { layers: [own], areas }, { areaSize: MAP })
    const activations = activate(wrinkles, random)
    const influenceOf = influenceAt(areas, activations, MAP)
    const cosine = 0.5 / Math.hypot(0.8, 0.1, 0.5)
    for (const metallic of [1, 0]) {
      // Metal has only specular light, and a material without reflectance only diffuse light, so each picture shows one of them.
      Object.assign(material, { metallic, roughness: 0.9, metallicF0Factor: metallic })
      for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0)
      const plain = await harness.render(scene, PIXELS)
      for (const [i, area] of wrinkles.areaNames.entries()) wrinkles.setActivation(area, activations[i])
      const shown = await harness.render(scene, PIXELS)
      let [error, effect] = [0, 0]
      for (let i = 0; i < PIXELS * PIXELS; i++) {
        const [u, v] = uvOf(i)
        const value = [reference.sampleArray(packGrays([own.occlusion!]), u, v, 0)]
        const [visibility] = reference.mixValues([1], [{ value, influence: influenceOf(u, v) }])
        const shadow = metallic ? reference.microShadow(visibility, cosine) : 1
        error = Math.max(error, Math.abs(shown[4 * i] - plain[4 * i] * shadow))
        effect = Math.max(effect, Math.abs(plain[4 * i] * (1 - shadow)))
      }
      expect(error).toBeLessThanOrEqual(2 / 255)
      if (metallic) expect(effect).toBeGreaterThan(8 / 255)
    }
    scene.dispose()
  })
})

/** Quantity that the picture shows. */
type Shown = 'colour' | 'roughness' | 'occlusion'

/** Material, and a function that returns its value of a kind without wrinkles, linear. */
interface Skin {
  material: PBRMaterial | StandardMaterial
  own(kind: Kind, u: number, v: number): number[]
}

const NOTHING = (kind: Kind) => (kind === 'blood' ? [0] : kind === 'baseColor' ? [1, 1, 1] : [1])

function physical(scene: Scene, _random: () => number, shown: Shown): Skin {
  const material = new PBRMaterial('skin', scene)
  Object.assign(material, { metallic: 0, roughness: 0.8 })
  if (shown === 'colour') material.unlit = true
  else Object.assign(material, { debugMode: SHOW[shown], debugLimit: -1 })
  return { material, own: NOTHING }
}

function physicalWithMaps(scene: Scene, random: () => number, shown: Shown): Skin {
  const { material } = physical(scene, random, shown) as { material: PBRMaterial }
  const [colours, rest] = [randomImage(random, MAP), randomImage(random, MAP)]
  const decoded = Uint16Array.from(colours.data, (byte) => ToHalfFloat(linear(byte / 255)))
  material.albedoTexture = RawTexture.CreateRGBATexture(
    decoded,
    MAP,
    MAP,
    scene,
    false,
    false,
    Constants.TEXTURE_BILINEAR_SAMPLINGMODE,
    Constants.TEXTURETYPE_HALF_FLOAT,
  )
  material.albedoTexture.gammaSpace = false
  material.metallicTexture = material.ambientTexture = linearTexture(rest, scene)
  material.useRoughnessFromMetallicTextureGreen = true
  material.useRoughnessFromMetallicTextureAlpha = false
  material.useAmbientInGrayScale = true
  const own = (kind: Kind, u: number, v: number) => {
    if (kind === 'blood') return [0]
    if (kind === 'baseColor') return colourAt(colours, u, v)
    return [reference.sampleArray(packColours([rest]), u, v, 0, kind === 'roughness' ? 1 : 0)]
  }
  return { material, own }
}

/** Creates an unlit white material. */
function standard(scene: Scene): Skin {
  const material = new StandardMaterial('skin', scene)
  material.disableLighting = true
  material.emissiveColor = Color3.White()
  return { material, own: NOTHING }
}

function standardWithMaps(scene: Scene, random: () => number): Skin {
  const { material } = standard(scene) as { material: StandardMaterial }
  const [colours, rest] = [randomImage(random, MAP), randomImage(random, MAP)]
  material.diffuseTexture = linearTexture(colours, scene)
  material.ambientTexture = linearTexture(rest, scene)
  const own = (kind: Kind, u: number, v: number) => {
    if (kind === 'blood') return [0]
    const at = (image: RgbaImage, channel: number) =>
      reference.sampleArray(packColours([image]), u, v, 0, channel)
    return [0, 1, 2].map((c) => (kind === 'baseColor' ? at(colours, c) ** 2.2 : at(rest, c)))
  }
  return { material, own }
}

function linearTexture(image: RgbaImage, scene: Scene): RawTexture {
  const texture = RawTexture.CreateRGBATexture(
    image.data,
    MAP,
    MAP,
    scene,
    false,
    false,
    Constants.TEXTURE_BILINEAR_SAMPLINGMODE,
  )
  texture.gammaSpace = false
  return texture
}

/** Sets random activations on all areas and returns them. */
function activate(wrinkles: Wrinkles, random: () => number): number[] {
  return wrinkles.areaNames.map((name) => {
    wrinkles.setActivation(name, random() * 0.6)
    return wrinkles.getActivation(name)
  })
}

async function compare(
  harness: BabylonHarness,
  random: () => number,
  kinds: Kind[][],
  shown: Shown,
  create: (scene: Scene, random: () => number, shown: Shown) => Skin,
) {
  const scene = harness.createScene()
  const layers = kinds.map((ofLayer, i) => randomLayer(random, `layer${i}`, ofLayer))
  const areas = randomAreas(random, 12, MAP).map((area, i) => ({
    ...area,
    layer: `layer${i % layers.length}`,
  }))
  const mesh = square(scene)
  const { material, own } = create(scene, random, shown)
  mesh.material = material
  const wrinkles = new Wrinkles(mesh, { layers, areas }, { areaSize: MAP })
  const plain = await harness.render(scene, PIXELS)
  const activations = activate(wrinkles, random)
  const pixels = await harness.render(scene, PIXELS)
  scene.dispose()
  const names = layers.map(({ name }) => name)
  const influence = influenceAt(areas, activations, MAP, names)
  const mixed = (kind: Kind, u: number, v: number) => {
    const base = own(kind, u, v)
    const sampled = layers.flatMap((layer, i) => {
      if (!layer[kind]) return []
      const stored = layerValue(layer, kind, u, v)
      return [{ value: base.map((_, c) => stored[c % stored.length]), influence: influence(u, v, i) }]
    })
    return reference.mixValues(base, sampled)
  }
  let [error, effect] = [0, 0]
  for (let i = 0; i < PIXELS * PIXELS; i++) {
    const [u, v] = uvOf(i)
    const exact = exactOf(shown, material, (kind) => mixed(kind, u, v))
    for (let c = 0; c < 3; c++) {
      error = Math.max(error, Math.abs(pixels[4 * i + c] - exact[c % exact.length]))
      effect = Math.max(effect, Math.abs(pixels[4 * i + c] - plain[4 * i + c]))
    }
  }
  return { error, effect }
}

function exactOf(shown: Shown, material: Skin['material'], mixed: (kind: Kind) => number[]): number[] {
  if (shown === 'occlusion') return mixed('occlusion')
  if (shown === 'roughness') return [0.8 * mixed('roughness')[0]]
  const colour = reference.bloodColour(mixed('baseColor'), mixed('blood')[0])
  if (material instanceof PBRMaterial) return colour
  // StandardMaterial multiplies its result by the occlusion in gamma space, where the exponent is 2.2.
  const occlusion = mixed('occlusion')
  return colour.map((value, c) => value * occlusion[c % occlusion.length] ** 2.2)
}

function uvOf(pixel: number): [number, number] {
  return [((pixel % PIXELS) + 0.5) / PIXELS, 1 - (Math.floor(pixel / PIXELS) + 0.5) / PIXELS]
}

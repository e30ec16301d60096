import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js'
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js'
import { Color3 } from '@babylonjs/core/Maths/math.color.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { LayerKind, RgbaImage } from 'furrow'
import { Wrinkles } from 'furrow/babylon'
import { packColours, reference } from 'furrow/internal'
import { afterEach, describe, expect, it } from 'vitest'
import { layer, randomAreas, randomNormals } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { largestDifference } from '../difference.ts'
import { influenceAt } from '../influence-at.ts'
import { type BabylonHarness, ENGINES, harnessOn, square } from './harness.ts'

const PIXELS = 32
const MAP = 16

/** Debug mode of Babylon.js that shows normals. */
const SHOW_NORMAL = 5

const KINDS: LayerKind[][] = [
  ['replace'],
  ['detail'],
  ['replace', 'replace'],
  ['detail', 'replace', 'detail'],
  ['replace', 'detail', 'replace', 'detail'],
]

describe.each(ENGINES)('normals in Babylon.js on %s', (name) => {
  const harness = harnessOn(name)
  afterEach(() => expect(harness.errors).toEqual([]))

  it.each([
    ['PBRMaterial', shownByPbr],
    ['StandardMaterial', shownByStandard],
  ] as const)('of a %s are within 2/255 of the reference', async (_, create) => {
    const random = seeded(5)
    for (const kinds of KINDS) {
      for (const hasMap of [true, false]) {
        const { worst, effect } = await compare(harness, random, kinds, hasMap, create)
        expect(worst).toBeLessThanOrEqual(2 / 255)
        expect(effect, 'the effect of the layers').toBeGreaterThan(16 / 255)
      }
    }
  })

  it("equal the material's own bit for bit without influence, and after dispose", async () => {
    const random = seeded(6)
    for (const hasMap of [true, false]) {
      const scene = harness.createScene()
      const { mesh } = skin(scene, random, hasMap, shownByPbr)
      const plain = await harness.render(scene, PIXELS)
      const wrinkles = new Wrinkles(mesh, randomLayers(random, ['replace', 'detail']), { areaSize: MAP })
      expect(await harness.render(scene, PIXELS)).toEqual(plain)
      wrinkles.setActivation('area0', 1)
      expect(await harness.render(scene, PIXELS)).not.toEqual(plain)
      wrinkles.mode = 'off'
      expect(await harness.render(scene, PIXELS)).toEqual(plain)
      wrinkles.mode = 'default'
      wrinkles.dispose()
      expect(await harness.render(scene, PIXELS)).toEqual(plain)
      expect((mesh.material as PBRMaterial).bumpTexture !== null).toBe(hasMap)
      scene.dispose()
    }
  })

  it('are drawn on a mesh that keeps its vertices only on the GPU', async () => {
    const pictures: Float32Array[] = []
    for (const isCleared of [false, true]) {
      const random = seeded(8)
      const scene = harness.createScene()
      const { mesh } = skin(scene, random, true, shownByPbr)
      const wrinkles = new Wrinkles(mesh, randomLayers(random, ['replace', 'detail']), { areaSize: MAP })
      wrinkles.setActivation('area0', 1)
      if (isCleared) scene.clearCachedVertexData()
      pictures.push(await harness.render(scene, PIXELS))
      scene.dispose()
    }
    expect(largestDifference(pictures[0], pictures[1])).toBeLessThanOrEqual(1 / 255)
  })

  it("follow a normal map whose offset the page changes, also beyond the edges of the layers' maps", async () => {
    const moved = (uOffset: number) => {
      const random = seeded(7)
      const scene = harness.createScene()
      const { mesh } = skin(scene, random, true, shownByPbr)
      const map = (mesh.material as PBRMaterial).bumpTexture as RawTexture
      map.uScale = map.vScale = 0.5
      map.uOffset = uOffset
      const wrinkles = new Wrinkles(mesh, randomLayers(random, ['replace', 'detail']), { areaSize: MAP })
      wrinkles.setActivation('area0', 1)
      return { scene, map }
    }
    const picture = ({ scene }: { scene: Scene }) => canvasPicture(harness, scene)
    const [face, beyond] = [moved(0.1), moved(0.8)]
    const before = await picture(face)
    face.map.uOffset = 0.8
    const shown = await picture(face)
    expect(largestDifference(shown, before)).toBeGreaterThan(10)
    expect(largestDifference(shown, await picture(beyond))).toBe(0)
    face.map.uOffset = 0.1
    expect(largestDifference(await picture(face), before)).toBe(0)
    for (const { scene } of [face, beyond]) scene.dispose()
  })

  it('stay the same when a second face joins the influence map', async () => {
    const random = seeded(9)
    const scene = harness.createScene()
    const { mesh } = skin(scene, random, true, shownByPbr)
    const wrinkles = new Wrinkles(mesh, randomLayers(random, ['replace', 'detail']), { areaSize: MAP })
    const plain = await canvasPicture(harness, scene)
    wrinkles.setActivation('area0', 1)
    const alone = await canvasPicture(harness, scene)
    expect(largestDifference(alone, plain)).toBeGreaterThan(10)
    const other = square(scene)
    other.position.x = 9
    other.material = mesh.material!.clone('other')
    const shared = new Wrinkles(other, wrinkles)
    expect(largestDifference(await canvasPicture(harness, scene), alone)).toBeLessThanOrEqual(1)
    shared.dispose()
    expect(largestDifference(await canvasPicture(harness, scene), alone)).toBeLessThanOrEqual(1)
    scene.dispose()
  })
})

/** Draws to the canvas, so that a material uses the same shaders in each picture. Each new render target would get new shaders. */
async function canvasPicture({ engine }: BabylonHarness, scene: Scene): Promise<Uint8Array> {
  await scene.whenReadyAsync()
  engine.beginFrame()
  scene.render()
  const pixels = engine.readPixels(0, 0, engine.getRenderWidth(), engine.getRenderHeight())
  engine.endFrame()
  return new Uint8Array((await pixels).buffer.slice(0))
}

/** Material that shows its normals, and a function that returns the colour expected for a tangent-space normal. */
interface Shown {
  material: PBRMaterial | StandardMaterial
  seen(normal: readonly number[]): number[]
}

/** Shows normals in world space, where z points away from the camera, mapped from -1..1 to 0..1. */
function shownByPbr(scene: Scene): Shown {
  const material = new PBRMaterial('skin', scene)
  Object.assign(material, { metallic: 0, roughness: 1, debugMode: SHOW_NORMAL, debugLimit: -1 })
  return { material, seen: ([x, y, z]) => [x, y, -z].map((value) => value * 0.5 + 0.5) }
}

/** Shows normals by three lights in red, green and blue along x, y and z. The harness decodes the output with an exponent of 2.2. */
function shownByStandard(scene: Scene): Shown {
  const material = new StandardMaterial('skin', scene)
  material.specularColor = Color3.Black()
  material.ambientColor = Color3.Black()
  for (const [axis, direction] of [
    [-1, 0, 0],
    [0, -1, 0],
    [0, 0, 1],
  ].entries()) {
    const light = new DirectionalLight('light', Vector3.FromArray(direction), scene)
    light.diffuse = Color3.FromArray([0, 1, 2].map((i) => Number(i === axis)))
  }
  return { material, seen: (normal) => normal.map((value) => Math.max(value, 0) ** 2.2) }
}

function skin(scene: Scene, random: () => number, hasMap: boolean, create: (scene: Scene) => Shown) {
  const { material, seen } = create(scene)
  const base = hasMap ? randomNormals(random, MAP) : flatNormals()
  if (hasMap) {
    material.bumpTexture = RawTexture.CreateRGBATexture(base.data, MAP, MAP, scene, false, false)
    material.invertNormalMapX = true
  }
  const mesh = square(scene)
  mesh.material = material
  return { mesh, seen, base }
}

function flatNormals(): RgbaImage {
  const data = Uint8Array.from({ length: 4 * MAP * MAP }, (_, i) => [127.5, 127.5, 255, 255][i % 4])
  return { width: MAP, height: MAP, data }
}

function randomLayers(random: () => number, kinds: readonly LayerKind[]) {
  return {
    layers: kinds.map((kind, i) => layer(`layer${i}`, kind, randomNormals(random, MAP))),
    areas: randomAreas(random, 12, MAP).map((area, i) => ({ ...area, layer: `layer${i % kinds.length}` })),
  }
}

async function compare(
  harness: BabylonHarness,
  random: () => number,
  kinds: readonly LayerKind[],
  hasMap: boolean,
  create: (scene: Scene) => Shown,
) {
  const scene = harness.createScene()
  const { mesh, seen, base } = skin(scene, random, hasMap, create)
  const { layers, areas } = randomLayers(random, kinds)
  const wrinkles = new Wrinkles(mesh, { layers, areas }, { areaSize: MAP })
  const activations = areas.map(() => random() * 0.5)
  for (const [i, { name }] of areas.entries()) wrinkles.setActivation(name, activations[i])
  const shown = await harness.render(scene, PIXELS)
  scene.dispose()
  const names = layers.map(({ name }) => name)
  const influence = influenceAt(areas, activations, MAP, names)
  const maps = packColours([base, ...layers.map(({ normal }) => normal as RgbaImage)])
  let [worst, effect] = [0, 0]
  for (let i = 0; i < PIXELS * PIXELS; i++) {
    const u = ((i % PIXELS) + 0.5) / PIXELS
    const v = 1 - (Math.floor(i / PIXELS) + 0.5) / PIXELS
    const normalOf = (map: number) =>
      map === 0 && !hasMap
        ? [0, 0, 1]
        : reference.unpackNormal([0, 1, 2].map((c) => reference.sampleArray(maps, u, v, map, c)))
    const mixed = kinds.map((kind, k) => ({ kind, normal: normalOf(k + 1), influence: influence(u, v, k) }))
    const exact = seen(reference.mixNormals(normalOf(0), mixed))
    const plain = seen(reference.mixNormals(normalOf(0), []))
    for (const axis of [0, 1, 2]) {
      worst = Math.max(worst, Math.abs(shown[4 * i + axis] - exact[axis]))
      effect = Math.max(effect, Math.abs(plain[axis] - exact[axis]))
    }
  }
  return { worst, effect }
}

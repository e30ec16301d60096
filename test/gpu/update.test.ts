import type { Area, GrayImage, Layer, RgbaImage, WrinkleSet } from 'furrow'
import {
  type Bounds,
  type LayerImages,
  removeArea,
  scaleLayer,
  updateArea,
  updateLayer,
  type WrinkleMode,
} from 'furrow/three'
import {
  AmbientLight,
  type DataArrayTexture,
  DirectionalLight,
  type Mesh,
  MeshStandardMaterial,
  Scene,
} from 'three'
import { afterEach, beforeEach, describe, expect, it } from 'vitest'
import { meshOf } from '../../packages/furrow/src/three/wrinkles-base.ts'
import { randomAreas, randomImage, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { deviceErrors } from './device-errors.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { readLevel } from './read-level.ts'

const AREA = 16
const MAP = 64
const KINDS = ['normal', 'baseColor', 'roughness', 'occlusion', 'blood'] as const

/** Rectangles to change: in the middle, at borders and corners, the complete map, and one texel. */
const REGIONS: Bounds[] = [
  { x0: 13, y0: 22, x1: 30, y1: 41 },
  { x0: 0, y0: 0, x1: 9, y1: 5 },
  { x0: 0, y0: 0, x1: MAP, y1: MAP },
  { x0: 51, y0: 60, x1: MAP, y1: MAP },
  { x0: 63, y0: 31, x1: 64, y1: 32 },
]

type AnyWrinkles = InstanceType<Harness['Wrinkles']>

describe.each(RENDERERS)('wrinkles that change while shown, on %s', (name) => {
  const harness = harnessOn(name)
  let errors: string[]
  beforeEach(() => {
    errors = name === 'webgpu' ? deviceErrors(harness) : []
  })
  afterEach(() => expect(errors).toEqual([]))

  /** Creates a scene with a square that has wrinkles. */
  function faceOf(source: WrinkleSet | AnyWrinkles, mode: WrinkleMode = 'default') {
    const mesh = square(new MeshStandardMaterial({ color: 0xd0e0f0 }))
    const wrinkles = new harness.Wrinkles(mesh, source, { areaSize: AREA, mode })
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.4)
    return { mesh, wrinkles }
  }

  /** Renders a picture, `pixels` wide. Small pictures show the smaller mipmap levels. */
  const picture = (mesh: Mesh, pixels = MAP, by = harness) => {
    const scene = new Scene()
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(0.3, 0.2, 1)
    scene.add(mesh, light, new AmbientLight(0xffffff, 1))
    return by.renderBytes(scene, squareCamera(), pixels)
  }

  /** Expects that new wrinkles with the same set give the same picture. Rounding may differ, because new wrinkles get another atlas cell. */
  async function expectFresh(mesh: Mesh, set: WrinkleSet, pixels: number, tolerance = 1) {
    const shown = await picture(mesh, pixels)
    const fresh = faceOf(set)
    const wanted = await picture(fresh.mesh, pixels)
    fresh.wrinkles.dispose()
    expect(largestDifference(shown, wanted)).toBeLessThanOrEqual(tolerance)
    return shown
  }

  /**
   * Expects GPU textures that equal those of new wrinkles with the same set. Mipmaps may differ a little, because some are computed on the CPU and
   * others on the GPU.
   *
   * @param by renderer that has drawn the wrinkles.
   */
  async function expectFreshTextures(wrinkles: AnyWrinkles, set: WrinkleSet, by = harness) {
    const fresh = faceOf(set)
    const [shown, wanted] = [wrinkles, fresh.wrinkles].map(texturesOf)
    for (const [i, texture] of shown.entries()) {
      const { width, height, depth } = texture.image as { width: number; height: number; depth: number }
      const levels = texture.generateMipmaps ? Math.floor(Math.log2(Math.max(width, height))) + 1 : 1
      for (let slice = 0; slice < depth; slice++) {
        for (let level = 0; level < levels; level++) {
          const [own, others] = [texture, wanted[i]].map((each) => readLevel(by, each, slice, level))
          // Mipmaps from the CPU and from the GPU differ by rounding, and by up to 22 for levels that are halved in only one direction.
          const isHalvedTwice = Math.min(width, height) >> (level - 1) > 1
          const tolerance = level === 0 ? 0 : isHalvedTwice ? 2 : 32
          expect(largestDifference(await own, await others)).toBeLessThanOrEqual(tolerance)
        }
      }
    }
    fresh.wrinkles.dispose()
  }

  it('show new area weights, repeatedly, as if created with them', async () => {
    const random = seeded(41)
    const set = randomMaps(random)
    const { mesh, wrinkles } = faceOf(set)
    let before = await picture(mesh)
    for (let i = 0; i < 4; i++) {
      // Changes the part of the texture that an area covers, and thus the area's rectangle. The last weights have another size and are resampled.
      const index = i % 2
      const weights =
        i === 3 ? randomWeights(random, 40) : cropped(randomWeights(random, AREA), 3 * i, 14 - i)
      updateArea(wrinkles, `area${index}`, weights)
      set.areas[index] = { ...set.areas[index], weights }
      const shown = await expectFresh(mesh, set, MAP)
      expect(largestDifference(shown, before)).toBeGreaterThan(8)
      before = shown
    }
    await expectFreshTextures(wrinkles, set)
    wrinkles.dispose()
  })

  it('keep the activations, layers and order of areas', async () => {
    const random = seeded(42)
    const set = randomMaps(random)
    const { mesh, wrinkles } = faceOf(set)
    await picture(mesh)
    const activations = wrinkles.areaNames.map((area) => wrinkles.getActivation(area))
    const weights = randomWeights(random, AREA)
    updateArea(wrinkles, 'area1', weights)
    await picture(mesh)
    expect(wrinkles.areaNames).toEqual(set.areas.map((area) => area.name))
    expect(wrinkles.areaNames.map((area) => wrinkles.getActivation(area))).toEqual(activations)
    expect(wrinkles.getArea('area1')).toEqual({ ...set.areas[1], weights })
    wrinkles.dispose()
  })

  it('show an area that is no longer empty, and hide an area that has become empty', async () => {
    const random = seeded(43)
    const set = randomMaps(random)
    const empty = { width: AREA, height: AREA, data: new Uint8Array(AREA * AREA) }
    const { mesh, wrinkles } = faceOf(set)
    await picture(mesh)
    for (const { name } of set.areas) updateArea(wrinkles, name, empty)
    for (const area of set.areas) area.weights = empty
    const plain = await expectFresh(mesh, set, MAP)
    set.areas[2].weights = cropped(randomWeights(random, AREA), 5, 9)
    updateArea(wrinkles, 'area2', set.areas[2].weights)
    expect(largestDifference(await expectFresh(mesh, set, MAP), plain)).toBeGreaterThan(8)
    wrinkles.dispose()
  })

  it('show new pixels of all maps of a layer, at any size on screen, as if created with them', async () => {
    const random = seeded(44)
    const set = randomMaps(random)
    const { mesh, wrinkles } = faceOf(set)
    let before = await picture(mesh)
    for (const [i, region] of REGIONS.entries()) {
      const layer = i % 2
      const images = repainted(random, set.layers[layer], region)
      updateLayer(wrinkles, `layer${layer}`, images, i === 2 ? undefined : region)
      Object.assign(set.layers[layer], images)
      const shown = await expectFresh(mesh, set, MAP)
      expect(largestDifference(shown, before)).toBeGreaterThan(8)
      before = shown
      for (const pixels of [24, 8, 2]) await expectFresh(mesh, set, pixels, 2)
      await expectFreshTextures(wrinkles, set)
    }
    wrinkles.dispose()
  })

  it.each(['default', 'composed'] as const)(
    'show layers at another strength, in the mode %s',
    async (mode) => {
      const set = randomMaps(seeded(48))
      const { mesh, wrinkles } = faceOf(set, mode)
      const other = faceOf(wrinkles, mode)
      const before = await picture(mesh)
      for (const [layer, scale] of [
        { normalScale: 0.3 },
        { normalScale: 1.6, occlusionStrength: 0.2, bloodAmplitude: 1.2 },
      ].entries()) {
        scaleLayer(wrinkles, `layer${layer}`, scale)
        Object.assign(set.layers[layer], scale)
      }
      const fresh = faceOf(set, mode)
      const expected = await picture(fresh.mesh)
      expect(largestDifference(expected, before)).toBeGreaterThan(8)
      for (const each of [mesh, other.mesh])
        expect(largestDifference(await picture(each), expected)).toBeLessThanOrEqual(1)
      for (const each of [other, fresh, { wrinkles }]) each.wrinkles.dispose()
    },
  )

  it.each([
    ['of 48 x 20 texels', 48, 20],
    ['of 64 x 4 texels', 64, 4],
  ])('show new pixels of maps %s', async (_, width, height) => {
    const random = seeded(45)
    const set = randomMaps(random, width, height)
    const { mesh, wrinkles } = faceOf(set)
    await picture(mesh)
    const region = { x0: 5, y0: 1, x1: 30, y1: 3 }
    const images = repainted(random, set.layers[1], region)
    updateLayer(wrinkles, 'layer1', images, region)
    Object.assign(set.layers[1], images)
    await expectFresh(mesh, set, MAP, 2)
    await expectFreshTextures(wrinkles, set)
    wrinkles.dispose()
  })

  it('show several changes between two frames, and changes before the first frame', async () => {
    const random = seeded(46)
    const set = randomMaps(random)
    const { mesh, wrinkles } = faceOf(set)
    for (const _ of [0, 1]) {
      for (const region of REGIONS.slice(0, 4)) {
        const images = repainted(random, set.layers[0], region)
        updateLayer(wrinkles, 'layer0', images, region)
        Object.assign(set.layers[0], images)
        set.areas[3].weights = randomWeights(random, AREA)
        updateArea(wrinkles, 'area3', set.areas[3].weights)
      }
      await expectFresh(mesh, set, MAP)
      await expectFreshTextures(wrinkles, set)
    }
    wrinkles.dispose()
  })

  it('change on all faces that share textures, until one of these faces gets other areas', async () => {
    const random = seeded(47)
    const set = randomMaps(random)
    const first = faceOf(set)
    const second = faceOf(first.wrinkles)
    for (const { mesh } of [first, second]) await picture(mesh)
    const images = repainted(random, set.layers[0], REGIONS[0])
    updateLayer(first.wrinkles, 'layer0', images, REGIONS[0])
    Object.assign(set.layers[0], images)
    set.areas[0].weights = randomWeights(random, AREA)
    updateArea(second.wrinkles, 'area0', set.areas[0].weights)
    for (const { mesh } of [second, first]) await expectFresh(mesh, set, MAP)
    removeArea(second.wrinkles, 'area1')
    // After this change the two faces share only their layers.
    updateArea(first.wrinkles, 'area0', randomWeights(random, AREA))
    await expectFresh(second.mesh, { ...set, areas: set.areas.filter(({ name }) => name !== 'area1') }, MAP)
    for (const { wrinkles } of [first, second]) wrinkles.dispose()
  })

  it('change in every renderer, however many changes the renderer has missed', async () => {
    const random = seeded(48)
    const set = randomMaps(random)
    const { wrinkles } = faceOf(set)
    const other = await createHarness(name)
    // Uploads the textures without drawing, because two `WebGPURenderer`s cannot draw one influence map in turn.
    const upload = (by: Harness) => meshOf(wrinkles).shaderInputs.textures.upload?.(by.renderer)
    for (const by of [harness, other]) upload(by)
    for (let i = 0; i < 80; i++) {
      const region = REGIONS[i % 4]
      const images = repainted(random, set.layers[0], region)
      updateLayer(wrinkles, 'layer0', images, region)
      Object.assign(set.layers[0], images)
      if (i % 20 === 0) upload(harness)
    }
    for (const by of [other, harness]) {
      upload(by)
      await expectFreshTextures(wrinkles, set, by)
    }
    wrinkles.dispose()
    other.dispose()
  })

  it.each(['composed', 'paper'] as const)('change in the %s mode', async (mode) => {
    const random = seeded(49)
    const set = randomMaps(random)
    set.layers = [{ name: 'layer0', kind: 'replace', normal: set.layers[0].normal }]
    for (const area of set.areas) area.layer = 'layer0'
    const { mesh, wrinkles } = faceOf(set, mode)
    let before = await picture(mesh)
    const expectSame = async () => {
      const shown = await picture(mesh)
      const fresh = faceOf(set, mode)
      expect(largestDifference(shown, await picture(fresh.mesh))).toBeLessThanOrEqual(1)
      fresh.wrinkles.dispose()
      expect(largestDifference(shown, before)).toBeGreaterThan(8)
      before = shown
    }
    const paint = () => {
      const images = { normal: repainted(random, set.layers[0], REGIONS[0]).normal! }
      updateLayer(wrinkles, 'layer0', images, REGIONS[0])
      Object.assign(set.layers[0], images)
    }
    paint()
    await expectSame()
    set.areas[0].weights = randomWeights(random, AREA)
    updateArea(wrinkles, 'area0', set.areas[0].weights)
    await expectSame()
    wrinkles.mode = 'off'
    paint()
    wrinkles.mode = mode
    await expectSame()
    wrinkles.dispose()
  })
})

/** Creates two layers with all maps, and eight areas. Some areas cover only a part of the texture. */
function randomMaps(random: () => number, width = MAP, height = width): WrinkleSet {
  const layers = (['replace', 'detail'] as const).map((kind, i): Layer => {
    const maps = Object.fromEntries(KINDS.map((map) => [map, randomMap(random, map, width, height)]))
    return {
      name: `layer${i}`,
      kind,
      bloodAmplitude: 0.5,
      ...(maps as unknown as Pick<Layer, (typeof KINDS)[number]>),
    }
  })
  const areas = randomAreas(random, 8, AREA).map((area, i): Area => {
    const weights = i % 2 ? area.weights : cropped(area.weights, i, AREA)
    return { ...area, weights, layer: `layer${i % 2}` }
  })
  return { layers, areas }
}

/** Copies all maps of a layer, with new random pixels in a rectangle. */
function repainted(random: () => number, layer: Layer, { x0, y0, x1, y1 }: Bounds): LayerImages {
  const images = KINDS.flatMap((kind) => {
    if (!layer[kind]) return []
    const { width, height, data } = layer[kind]
    const [copy, other] = [data.slice(), randomMap(random, kind, width, height).data]
    const channels = data.length / (width * height)
    for (let y = y0; y < y1; y++) {
      const [start, end] = [(y * width + x0) * channels, (y * width + x1) * channels]
      copy.set(other.subarray(start, end), start)
    }
    return [[kind, { width, height, data: copy }]]
  })
  return Object.fromEntries(images)
}

function randomMap(random: () => number, kind: (typeof KINDS)[number], width: number, height: number) {
  if (kind === 'baseColor') return randomImage(random, width, height)
  if (kind !== 'normal') return { width, height, data: randomWeights(random, width, height).data }
  const { data } = randomNormals(random, Math.max(width, height))
  return { width, height, data: data.slice(0, 4 * width * height) } satisfies RgbaImage
}

function randomWeights(random: () => number, width: number, height = width): GrayImage {
  return { width, height, data: Uint8Array.from({ length: width * height }, () => random() * 256) }
}

/** Returns an image whose values are 0 outside the columns and rows `from` to `to - 1`. */
function cropped({ width, height, data }: GrayImage, from: number, to: number): GrayImage {
  const isInside = (x: number) => x >= from && x < to
  const kept = data.map((weight, i) => (isInside(i % width) && isInside(Math.floor(i / width)) ? weight : 0))
  return { width, height, data: kept }
}

function texturesOf(wrinkles: AnyWrinkles): DataArrayTexture[] {
  const { textures, areas } = meshOf(wrinkles).shaderInputs
  const maps = [textures.normals, ...Object.values(textures.values)]
  return [areas.texture, ...maps.map(({ texture }) => texture)] as DataArrayTexture[]
}

import type { WrinklesOptions } from 'furrow/three'
import { DirectionalLight, MeshPhysicalMaterial, Scene, type Texture } from 'three'
import { expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import {
  createHarness,
  type Harness,
  imagesOf,
  LONGEST_TEST_RENDERERS,
  square,
  squareCamera,
} from './harness.ts'
import { normalMap } from './normal-map.ts'

/** Of pictures: no more than the mode auto asks for. */
const SIDE = 64

/** What nobody sees: two steps of 8 bits. */
const UNSEEN = 2

/** A face that one renderer draws. */
function faceOn(
  harness: Harness,
  options: WrinklesOptions = {},
  side = 16,
  material = new MeshPhysicalMaterial(),
) {
  const mesh = square(material)
  const light = new DirectionalLight()
  light.position.set(1, 1, 1)
  const scene = new Scene().add(mesh, light)
  const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(4), 6, 8, side), { areaSize: 8, ...options })
  const set = (value: number) => {
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, value)
  }
  set(0.4)
  const picture = async () => (await harness.renderBytes(scene, squareCamera(), SIDE)).slice()
  return {
    set,
    wrinkles,
    scene,
    picture,
    /** How many images a picture takes. */
    async images() {
      const before = imagesOf(harness.renderer)
      await picture()
      return imagesOf(harness.renderer) - before
    },
  }
}

it.each(LONGEST_TEST_RENDERERS)(
  'faces of two renderers on one page do not disturb each other on %s',
  async (name) => {
    const harnesses = [await createHarness(name), await createHarness(name)]
    // One has drawn more images than the other, such as those of a page that loads.
    for (const lead of [0, 1, 2, 3]) {
      const faces = harnesses.map((harness) => faceOn(harness))
      const [first, second] = faces
      for (let i = 0; i < lead; i++) harnesses[1].renderer.render(new Scene(), squareCamera())
      const wanted = await first.picture()
      expect(new Set(wanted).size).toBeGreaterThan(8)
      for (let i = 0; i < 3; i++) {
        expect(largestDifference(await second.picture(), wanted), `${lead} second ${i}`).toBe(0)
        expect(largestDifference(await first.picture(), wanted), `${lead} first ${i}`).toBe(0)
      }
      // What stands is not drawn again because the other renderer drew its own.
      for (let i = 0; i < 2; i++) for (const { images } of faces) expect(await images()).toBe(1)
      for (const { set } of faces) set(0.9)
      const moved = await first.picture()
      expect(largestDifference(moved, wanted)).toBeGreaterThan(8)
      expect(largestDifference(await second.picture(), moved)).toBe(0)
      for (const { wrinkles } of faces) wrinkles.dispose()
    }
    for (const { dispose } of harnesses) dispose()
  },
)

it.each(LONGEST_TEST_RENDERERS)('faces of two renderers settle in the mode auto on %s', async (name) => {
  const harnesses = [await createHarness(name), await createHarness(name)]
  const faces = harnesses.map((harness) => faceOn(harness, { mode: 'auto' }))
  const composed = new Set()
  for (const { wrinkles } of faces) {
    const { mesh } = wrinkles
    const material = mesh.material as MeshPhysicalMaterial
    const { onBeforeRender } = mesh
    mesh.onBeforeRender = (...drawn) => {
      onBeforeRender.apply(mesh, drawn)
      if (material.normalMap?.isRenderTargetTexture) composed.add(mesh)
    }
  }
  for (let i = 0; i < 200 && composed.size < 2; i++) {
    for (const { picture } of faces) await picture()
    await new Promise((resolve) => setTimeout(resolve, 5))
  }
  expect(composed.size).toBe(2)
  for (const { wrinkles } of faces) wrinkles.dispose()
  for (const { dispose } of harnesses) dispose()
})

it.each(LONGEST_TEST_RENDERERS)(
  'a face that two renderers draw in turns settles in the mode auto on %s',
  async (name) => {
    const harnesses = [await createHarness(name), await createHarness(name)]
    const material = new MeshPhysicalMaterial({ normalMap: normalMap(5, 4 * SIDE) })
    const { wrinkles, set, scene } = faceOn(harnesses[0], { mode: 'auto' }, 4 * SIDE, material)
    const { mesh } = wrinkles
    const reach = wrinkles.editable('test').inputs.reach.value
    const maps = new Set<Texture>()
    /** The renderers whose last draw showed a composed map. */
    const composing = new Set<unknown>()
    const { onBeforeRender } = mesh
    mesh.onBeforeRender = (renderer, ...drawn) => {
      onBeforeRender.call(mesh, renderer, ...drawn)
      const map = material.normalMap!
      composing.delete(renderer)
      // A dual map leaves influence to mix in.
      if (!map.isRenderTargetTexture || reach.x < reach.z) return
      composing.add(renderer)
      maps.add(map)
    }
    // Of other sizes, which need other maps.
    const pictureOf = async (harness: Harness) => {
      const side = harness === harnesses[0] ? SIDE : 4 * SIDE
      return (await harness.renderBytes(scene, squareCamera(), side)).slice()
    }
    /** Frames of these in turns, until one of them is composed. */
    const settle = async (drawing: Harness[]) => {
      for (let i = 0; i < 200 && composing.size === 0; i++) {
        for (const harness of drawing) await pictureOf(harness)
        await new Promise((resolve) => setTimeout(resolve, 5))
      }
      expect(composing.size).toBe(1)
    }
    const wanted = new Map<Harness, Uint8Array>()
    for (const harness of harnesses) wanted.set(harness, await pictureOf(harness))
    await settle(harnesses)
    // Longer than a face must be still for.
    for (let i = 0; i < 60; i++) for (const harness of harnesses) await pictureOf(harness)
    expect(maps.size).toBe(1)
    const owner = harnesses.find(({ renderer }) => composing.has(renderer))!
    const other = harnesses.find((harness) => harness !== owner)!
    expect(composing.has(other.renderer)).toBe(false)
    expect(largestDifference(await pictureOf(owner), wanted.get(owner)!)).toBeLessThanOrEqual(UNSEEN)
    expect(largestDifference(await pictureOf(other), wanted.get(other)!)).toBe(0)
    // It moves, and holds still again.
    set(0.9)
    const moved = await pictureOf(other)
    expect(largestDifference(moved, wanted.get(other)!)).toBeGreaterThan(UNSEEN)
    expect(largestDifference(await pictureOf(owner), wanted.get(owner)!)).toBeGreaterThan(UNSEEN)
    expect(composing.size).toBe(0)
    await settle(harnesses)
    expect(composing.has(owner.renderer)).toBe(true)
    // That one is used no more.
    composing.clear()
    await settle([other])
    expect(largestDifference(await pictureOf(other), moved)).toBeLessThanOrEqual(UNSEEN)
    wrinkles.dispose()
    for (const { dispose } of harnesses) dispose()
  },
)

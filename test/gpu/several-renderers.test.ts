import type { WrinklesOptions } from 'furrow/three'
import { DirectionalLight, MeshPhysicalMaterial, Scene } from 'three'
import { expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness, RENDERERS, square, squareCamera } from './harness.ts'

/** Of pictures: no more than the mode auto asks for. */
const SIDE = 64

/** A face that one renderer draws. */
function faceOn(harness: Harness, options: WrinklesOptions = {}) {
  const mesh = square(new MeshPhysicalMaterial())
  const light = new DirectionalLight()
  light.position.set(1, 1, 1)
  const scene = new Scene().add(mesh, light)
  const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(4), 6, 8, 16), { areaSize: 8, ...options })
  const set = (value: number) => {
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, value)
  }
  set(0.4)
  const picture = async () => (await harness.renderBytes(scene, squareCamera(), SIDE)).slice()
  const drawn = () => {
    const { info } = harness.renderer
    return 'calls' in info ? info.calls : info.render.frame
  }
  return {
    set,
    wrinkles,
    picture,
    /** How many images a picture takes. */
    async images() {
      const before = drawn()
      await picture()
      return drawn() - before
    },
  }
}

it.each(RENDERERS)('faces of two renderers on one page do not disturb each other on %s', async (name) => {
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
})

it.each(RENDERERS)('faces of two renderers settle in the mode auto on %s', async (name) => {
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

import { DirectionalLight, Mesh, MeshStandardMaterial, PlaneGeometry, RenderTarget, Scene } from 'three'
import { mrt, normalView, output } from 'three/tsl'
import type { WebGPURenderer } from 'three/webgpu'
import { expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness, RENDERERS, square, squareCamera } from './harness.ts'

const SIDE = 32

/** A square with wrinkles, and before it a mesh that is drawn first and receives its shadow. */
function sceneOf(harness: Harness) {
  const light = new DirectionalLight('white', 3)
  light.position.set(0.5, 0.5, 1)
  light.castShadow = true
  light.shadow.bias = -0.01
  light.shadow.mapSize.set(64, 64)
  Object.assign(light.shadow.camera, { left: -3, right: 3, top: 3, bottom: -3, near: 0.01, far: 10 })
  const front = new Mesh(new PlaneGeometry(0.2, 0.2), new MeshStandardMaterial())
  front.position.set(0.9, 0.9, 0.5)
  const mesh = square(new MeshStandardMaterial())
  mesh.castShadow = mesh.receiveShadow = front.receiveShadow = true
  harness.renderer.shadowMap.enabled = true
  const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(4), 6, 8, 16), { areaSize: 8 })
  return { scene: new Scene().add(mesh, front, light), wrinkles }
}

/** A picture of it, and the same after what it shows was drawn beside frames. */
async function expectWrinkles(harness: Harness, shoot: (scene: Scene) => Promise<Uint8Array>) {
  const { scene, wrinkles } = sceneOf(harness)
  const set = (value: number) => {
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, value)
  }
  set(0.4)
  const shown = await shoot(scene)
  for (const value of [0, 0.4]) {
    set(value)
    wrinkles.update(harness.renderer)
  }
  expect(largestDifference(await shoot(scene), shown)).toBe(0)
  wrinkles.mode = 'off'
  expect(largestDifference(await shoot(scene), shown)).toBeGreaterThan(8)
  wrinkles.dispose()
}

it.each(RENDERERS)('wrinkles of a face that is drawn as a shadow first are there on %s', async (name) => {
  const harness = await createHarness(name)
  await expectWrinkles(harness, async (scene) =>
    (await harness.renderBytes(scene, squareCamera(), SIDE)).slice(),
  )
  harness.dispose()
})

it.each(RENDERERS.slice(1))(
  'passes with several outputs, and of what is opaque, have wrinkles on %s',
  async (name) => {
    const harness = await createHarness(name)
    const renderer = harness.renderer as WebGPURenderer
    const target = new RenderTarget(64, 64, { count: 2 })
    for (const [i, texture] of target.textures.entries()) texture.name = ['output', 'normal'][i]
    await expectWrinkles(harness, async (scene) => {
      renderer.setRenderTarget(target)
      renderer.setMRT(mrt({ output, normal: normalView }))
      renderer.transparent = false
      renderer.render(scene, squareCamera())
      expect(renderer.getMRT()).not.toBe(null)
      renderer.transparent = true
      renderer.setMRT(null)
      renderer.setRenderTarget(null)
      return ((await renderer.readRenderTargetPixelsAsync(target, 0, 0, 64, 64)) as Uint8Array).slice()
    })
    target.dispose()
    harness.dispose()
  },
)

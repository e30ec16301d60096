import { type WrinkleMode, type WrinklesBase, wrinklesOf } from 'furrow/three'
import { DirectionalLight, Scene } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { beforeAll, describe, expect, it } from 'vitest'
import { harnessOn, RENDERERS, squareCamera } from '../harness.ts'
import { wrinkledFile } from '../wrinkled-file.ts'

describe.each(RENDERERS)('a loaded face on %s', (name) => {
  const harness = harnessOn(name)
  let file: Uint8Array<ArrayBuffer>
  beforeAll(async () => {
    file = await wrinkledFile()
  })

  async function load(mode: WrinkleMode, fadeBelow = 0) {
    const loader = new GLTFLoader().register((parser) => new harness.Plugin(parser, { mode, fadeBelow }))
    const gltf = await loader.parseAsync(file.slice().buffer, '')
    const [wrinkles] = wrinklesOf(gltf) as [WrinklesBase]
    wrinkles.driven = false
    wrinkles.setActivation('a', 1)
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(1, 1, 1)
    const scene = new Scene().add(gltf.scene, light)
    const picture = async () => (await harness.renderBytes(scene, squareCamera(), 32)).join()
    return { wrinkles, picture }
  }

  it('has wrinkles that are instances of the imported class', async () => {
    const { wrinkles } = await load('default')
    expect(wrinkles).toBeInstanceOf(harness.Wrinkles)
    expect(wrinkles.constructor).toBe(harness.Wrinkles)
    wrinkles.dispose()
  })

  it.each(['composed', 'paper'] as const)('shows the mode %s as soon as it is set', async (mode) => {
    const usual = await load('default')
    const before = await usual.picture()
    const expected = await load(mode)
    const wanted = await expected.picture()
    expect(wanted).not.toBe(before)
    usual.wrinkles.mode = mode
    expect(await usual.picture()).toBe(wanted)
    usual.wrinkles.mode = 'default'
    expect(await usual.picture()).toBe(before)
    usual.wrinkles.dispose()
    expected.wrinkles.dispose()
  })

  it('shows no wrinkles from the first frame on if it is small on screen', async () => {
    const [hidden, usual] = [await load('off'), await load('default')]
    const plain = await hidden.picture()
    expect(await usual.picture()).not.toBe(plain)
    // The face fills a picture of 32 pixels, less than the 1000 below which wrinkles fade.
    const small = await load('default', 1000)
    expect(await small.picture()).toBe(plain)
    for (const { wrinkles } of [hidden, usual, small]) wrinkles.dispose()
  })
})

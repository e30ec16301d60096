import { type WrinkleMode, type WrinklesBase, wrinklesOf } from 'furrow/three'
import { DirectionalLight, type Mesh, Scene } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterAll, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { FADE } from '../../../packages/furrow/src/three/fading/fade.ts'
import { PARTS as WEBGL } from '../../../packages/furrow/src/three/webgl/webgl-wrinkles.ts'
import { PARTS as WEBGPU } from '../../../packages/furrow/src/three/webgpu/webgpu-wrinkles.ts'
import { createHarness, type Harness, RENDERERS, squareCamera } from '../harness.ts'
import { wrinkledFile } from '../wrinkled-file.ts'

/** As on a page that imports the loader alone. */
describe.each(RENDERERS)('modes that are fetched, on %s', (name) => {
  const parts = name === 'webgl' ? WEBGL : WEBGPU
  const { others } = parts
  let harness: Harness
  let file: Uint8Array<ArrayBuffer>
  beforeAll(async () => {
    harness = await createHarness(name)
    file = await wrinkledFile()
  })
  afterAll(() => harness.dispose())
  beforeEach(() => {
    others.value = null
  })

  async function load(mode: WrinkleMode, fadeBelow = 0) {
    const loader = new GLTFLoader().register((parser) => new harness.Plugin(parser, { mode, fadeBelow }))
    const gltf = await loader.parseAsync(file.slice().buffer, '')
    const [wrinkles] = wrinklesOf(gltf) as [WrinklesBase]
    expect(wrinkles).toBeInstanceOf(harness.Wrinkles)
    wrinkles.driven = false
    wrinkles.setActivation('a', 1)
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(1, 1, 1)
    const scene = new Scene().add(gltf.scene, light)
    const picture = async () => (await harness.renderBytes(scene, squareCamera(), 32)).join()
    return { wrinkles, mesh: wrinkles.mesh as Mesh, picture }
  }

  it.each(['composed', 'paper'] as const)('%s is shown when it is there', async (mode) => {
    const usual = await load('default')
    const before = await usual.picture()
    const expected = await load(mode)
    expect(others.value).not.toBeNull()
    const wanted = await expected.picture()
    expect(wanted).not.toBe(before)

    others.value = null
    usual.wrinkles.mode = mode
    expect(usual.wrinkles.mode).toBe(mode)
    expect(await usual.picture()).toBe(before)
    await vi.waitFor(async () => expect(await usual.picture()).toBe(wanted))
    usual.wrinkles.mode = 'default'
    expect(await usual.picture()).toBe(before)
    usual.wrinkles.dispose()
    expected.wrinkles.dispose()
  })

  it('a material that shows influence is black until then', async () => {
    const { wrinkles, mesh, picture } = await load('default')
    const shown = mesh.material
    const views = [undefined, 'a'].map((area) => wrinkles.createInfluenceMaterial(area))
    for (const view of views) {
      others.value = null
      mesh.material = wrinkles.createInfluenceMaterial()
      const black = await picture()
      mesh.material = view
      await vi.waitFor(async () => expect((await picture()) === black).toBe(false))
    }
    mesh.material = shown
    wrinkles.dispose()
  })

  it('what fades small faces is there in the first frame', async () => {
    FADE.value = null
    const hidden = await load('off')
    const plain = await hidden.picture()
    const usual = await load('default')
    expect(await usual.picture()).not.toBe(plain)
    expect(FADE.value).toBeNull()
    // The faces fill a picture of 32 pixels.
    const small = await load('default', 1000)
    expect(FADE.value).not.toBeNull()
    expect(await small.picture()).toBe(plain)
    for (const { wrinkles } of [hidden, usual, small]) wrinkles.dispose()
  })

  it('the mode that was set last is shown', async () => {
    const { wrinkles, picture } = await load('default')
    const before = await picture()
    wrinkles.mode = 'composed'
    wrinkles.mode = 'default'
    await others.load()
    expect(wrinkles.mode).toBe('default')
    expect(await picture()).toBe(before)
    wrinkles.mode = 'off'
    wrinkles.dispose()
  })

  it('a face whose shader the GPU refuses is plain at once, and is told of when that was fetched', async () => {
    const hidden = await load('off')
    const plain = await hidden.picture()
    const { wrinkles, picture } = await load('default')
    expect(await picture()).not.toBe(plain)
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const refused = vi.spyOn(parts, 'faultOf').mockReturnValueOnce('too many samplers')
    expect(await picture()).toBe(plain)
    expect(wrinkles.mode).toBe('off')
    await vi.waitFor(() => expect(warn).toHaveBeenCalledOnce())
    expect(warn.mock.calls[0][0]).toMatch(
      /does not compile in the default mode, .*"too many samplers"; use the composed mode/,
    )
    refused.mockRestore()
    warn.mockRestore()
    for (const own of [hidden.wrinkles, wrinkles]) own.dispose()
  })

  it('a mode that cannot be fetched leaves what is shown, with a warning', async () => {
    const { wrinkles, picture } = await load('default')
    const before = await picture()
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const fetch = vi.spyOn(others, 'load').mockRejectedValue(new Error('no network'))
    wrinkles.mode = 'composed'
    await vi.waitFor(() => expect(wrinkles.mode).toBe('default'))
    expect(warn.mock.calls).toEqual([['no network']])
    fetch.mockRestore()
    warn.mockRestore()
    expect(await picture()).toBe(before)
    wrinkles.dispose()
  })
})

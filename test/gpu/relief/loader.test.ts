import { readWrinkleMaps, wrinklesOf } from 'furrow/three'
import type { Mesh } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { createHarness, RENDERERS, squareCamera } from '../harness.ts'
import { wrinkledFile } from '../wrinkled-file.ts'
import { sceneOf } from './ball.ts'

/** Makes a file whose layer has heights in the texture `index`, with the largest amplitude that a mesh of this size allows. */
// biome-ignore lint/suspicious/noExplicitAny: the complete JSON of the file
const fileWithHeights = (index = 2, edit: (json: any) => unknown = () => {}) =>
  wrinkledFile(
    ({ layers: [layer] }) => Object.assign(layer, { heightTexture: { index, amplitude: 0.05 } }),
    edit,
  )

/** Makes a file whose height image is invalid. */
const fileWithoutImage = () =>
  fileWithHeights(3, (json) => {
    json.images.push({ uri: 'data:image/png;base64,AAAA' })
    json.textures.push({ source: json.images.length - 1 })
  })

/** Creates a camera that sees only a few millimetres. */
function close() {
  const camera = squareCamera()
  camera.zoom = 200
  camera.updateProjectionMatrix()
  return camera
}

function meshesOf({ scene }: GLTF): Mesh[] {
  return scene.getObjectsByProperty('isMesh', true) as Mesh[]
}

afterEach(() => {
  vi.restoreAllMocks()
})

describe.each(RENDERERS)('a face loaded for %s', (name) => {
  const load = async (file: Uint8Array<ArrayBuffer>, relief: 'on' | 'off' | 'near') => {
    const harness = await createHarness(name)
    const loader = new GLTFLoader().register((parser) => new harness.Plugin(parser, { relief }))
    return { harness, gltf: await loader.parseAsync(file.slice().buffer, '') }
  }

  it('shows relief on all primitives, and separately on copies', async () => {
    // Ignores the warning that a quad of one metre exceeds the limit of triangles.
    vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { harness, gltf } = await load(await fileWithHeights(), 'on')
    const meshes = meshesOf(gltf)
    await wrinklesOf(meshes[0])!.reliefReady()
    expect(meshes.map(({ children }) => children.length)).toEqual([1, 1])
    const copy = gltf.scene.clone()
    const copies = meshesOf({ scene: copy } as GLTF)
    expect(copies).toHaveLength(2)
    await harness.renderBytes(sceneOf(gltf.scene as never, copy as never), squareCamera(), 32)
    await wrinklesOf(copies[0])!.reliefReady()
    expect(copies[0].children.filter((child) => 'isReliefMesh' in child)).toHaveLength(1)
    harness.dispose()
  })

  it('reads no heights without relief, and ignores damaged ones', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { harness, gltf } = await load(await fileWithoutImage(), 'off')
    const [mesh] = meshesOf(gltf)
    await harness.renderBytes(sceneOf(gltf.scene as never), close(), 32)
    await new Promise((resolve) => setTimeout(resolve, 100))
    expect(mesh.children).toEqual([])
    expect(warn.mock.calls.flat().join()).not.toContain('relief')
    harness.dispose()
  })

  it('reads heights in mode near only when a millimetre exceeds a pixel', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { harness, gltf } = await load(await fileWithoutImage(), 'near')
    const scene = sceneOf(gltf.scene as never)
    await harness.renderBytes(scene, squareCamera(), 32)
    await new Promise((resolve) => setTimeout(resolve, 100))
    expect(warn).not.toHaveBeenCalled()
    await harness.renderBytes(scene, close(), 32)
    await vi.waitFor(() => expect(warn).toHaveBeenCalledOnce())
    expect(warn.mock.lastCall![0]).toContain('the wrinkles are shown without relief')
    harness.dispose()
  })

  it('has no relief, but wrinkles, if heights cannot be read', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { harness, gltf } = await load(await fileWithoutImage(), 'on')
    const [mesh] = meshesOf(gltf)
    expect(wrinklesOf(mesh)).toBeDefined()
    expect(warn).not.toHaveBeenCalled()
    await wrinklesOf(mesh)!.reliefReady()
    expect(mesh.children).toEqual([])
    expect(warn).toHaveBeenCalledOnce()
    expect(warn.mock.lastCall![0]).toContain('the wrinkles are shown without relief')
    harness.dispose()
  })
})

it("furrow/three exposes a file's heights", async () => {
  const gltf = await new GLTFLoader().parseAsync((await fileWithHeights()).buffer, '')
  const [{ set }] = await readWrinkleMaps(gltf)
  expect(set.layers[0]).toMatchObject({ height: { width: 16, height: 16 }, heightAmplitude: 0.05 })
})

import { WrinkleLoaderPlugin, wrinklesOf } from 'furrow/three'
import { DirectionalLight, LoadingManager, Scene } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import {
  afterAll,
  afterEach,
  beforeAll,
  beforeEach,
  describe,
  expect,
  it,
  type MockInstance,
  vi,
} from 'vitest'
import type { DamagedFace } from './damaged-faces.ts'
import { largestDifference, ROUNDING } from './difference.ts'
import { harnessOn, squareCamera } from './harness.ts'

describe('the loader and furrow validate', () => {
  const harness = harnessOn('webgl')
  let ktx2: KTX2Loader
  let faces: DamagedFace[]
  let warn: MockInstance<typeof console.warn>
  beforeAll(async () => {
    ktx2 = new KTX2Loader()
      .setTranscoderPath('/node_modules/three/examples/jsm/libs/basis/')
      .detectSupport(harness.renderer)
    faces = await (await fetch('/damaged-faces.json')).json()
  })
  afterAll(() => {
    ktx2.dispose()
  })
  beforeEach(() => {
    warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    vi.spyOn(console, 'error').mockImplementation(() => {})
  })
  afterEach(() => vi.restoreAllMocks())

  const load = (file: ArrayBuffer | string, manager?: LoadingManager): Promise<GLTF> => {
    const loader = new GLTFLoader(manager).setKTX2Loader(ktx2)
    return loader.register((parser) => new WrinkleLoaderPlugin(parser)).parseAsync(file, '')
  }

  it('agree on intact and damaged files of all kinds', async () => {
    const differing: string[] = []
    let refused = 0
    for (const { name, file, problem, isUnsure } of faces) {
      warn.mockClear()
      const [wrinkles] = wrinklesOf(await load(bytesOf(file).buffer))
      if (problem !== null) refused++
      if (Boolean(wrinkles) !== (problem === null) && !(isUnsure && wrinkles)) {
        const loader = wrinkles ? 'yes' : warn.mock.calls[0]
        differing.push(`${name}: validate: ${problem ?? 'yes'}; loader: ${loader}`)
      }
      wrinkles?.dispose()
    }
    expect(differing).toEqual([])
    // Many files must be refused and many accepted; otherwise the agreement proves nothing.
    expect(refused).toBeGreaterThan(faces.length / 3)
    expect(refused).toBeLessThan((faces.length * 4) / 5)
  })

  it.each(['uastc images and an array', 'etc1s images', 'webp'])(
    'treat %s next to a .gltf as in one file',
    async (kind) => {
      const { file, problem } = faces.find(({ name }) => name === kind)!
      const { json, files } = split(bytesOf(file))
      const addresses = new Map(files.map(([name, bytes]) => [name, URL.createObjectURL(new Blob([bytes]))]))
      const manager = new LoadingManager().setURLModifier((url) => addresses.get(url) ?? url)
      const beside = await load(JSON.stringify(json), manager)
      expect(warn.mock.calls).toEqual([])
      expect(problem).toBeNull()
      const picture = await pictureOf(beside)
      const inOne = await pictureOf(await load(bytesOf(file).buffer))
      expect(largestDifference(picture, inOne)).toBeLessThan(ROUNDING)
      expect(picture).not.toEqual(await pictureOf(beside, 0))
      for (const address of addresses.values()) URL.revokeObjectURL(address)
    },
  )

  async function pictureOf(gltf: GLTF, activation = 1): Promise<Float32Array> {
    const [wrinkles] = wrinklesOf(gltf)
    wrinkles.driven = false
    for (const area of wrinkles.areaNames) wrinkles.setActivation(area, activation)
    const light = new DirectionalLight(0xffffff, 2)
    light.position.set(1, 1, 1)
    return harness.render(new Scene().add(gltf.scene, light), squareCamera(), 32)
  }
})

const bytesOf = (base64: string) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))

/** Splits a `.glb` into a `.gltf` and separate files for buffer and images. */
function split(glb: Uint8Array<ArrayBuffer>) {
  const length = new DataView(glb.buffer).getUint32(12, true)
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)))
  const buffer = glb.slice(28 + length)
  const files: [name: string, bytes: Uint8Array<ArrayBuffer>][] = [['face.bin', buffer]]
  json.buffers[0].uri = 'face.bin'
  for (const [i, image] of json.images.entries()) {
    const { byteOffset = 0, byteLength } = json.bufferViews[image.bufferView]
    image.uri = `image-${i}`
    delete image.bufferView
    files.push([image.uri, buffer.slice(byteOffset, byteOffset + byteLength)])
  }
  return { json, files }
}

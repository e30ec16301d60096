import { FurrowError } from 'furrow'
import { readWrinkleMaps, WrinkleLoaderPlugin, wrinklesOf } from 'furrow/three'
import type { WebGLRenderer } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { beforeAll, describe, expect, it, onTestFinished } from 'vitest'
import { editGlb } from '../../glb.ts'
import { createHarness, harnessOn, RENDERERS } from '../harness.ts'
import { grayPng } from '../images.ts'
import { litPicture, loadFile } from '../loaded.ts'
import { quietConsole } from '../quiet-console.ts'
import { driver, wrinkledFile } from '../wrinkled-file.ts'

const written = quietConsole()

/** Damages the JSON of a file. Receives the JSON of the extension and the complete JSON. */
// biome-ignore lint/suspicious/noExplicitAny: tests edit the JSON in ways that no type allows
type Spoil = (maps: any, json: any) => unknown

const spoiled = (spoil: Spoil) =>
  wrinkledFile(undefined, (json) => spoil(json.materials[0].extensions.FURROW_wrinkle_maps, json))

/** Returns the JSON of the image with the normals of the first layer. */
// biome-ignore lint/suspicious/noExplicitAny: as above
const normals = (maps: any, json: any): any =>
  json.images[json.textures[maps.layers[0].normalTexture.index].source]

const uris = { large: '', small: '' }

beforeAll(async () => {
  const toUri = async (image: Promise<Blob>) => {
    const bytes = new Uint8Array(await (await image).arrayBuffer())
    return `data:image/png;base64,${btoa(String.fromCharCode(...bytes))}`
  }
  uris.large = await toUri(grayPng(8193, 1, 255))
  uris.small = await toUri(grayPng(2, 2, 128))
})

const DAMAGES: [what: string, spoil: Spoil, warning: RegExp][] = [
  [
    'null',
    (_, json) => (json.materials[0].extensions.FURROW_wrinkle_maps = null),
    /must be an object, got null/,
  ],
  [
    'a texture that is null',
    (maps, json) => (json.textures[maps.areas[0].texture.index] = null),
    /the wrinkles cannot be read/,
  ],
  [
    'a texture without an image',
    (maps, json) => (json.textures[maps.areas[0].texture.index] = {}),
    /the wrinkles cannot be read/,
  ],
  [
    'an image that is cut off',
    (maps, json) => (json.bufferViews[normals(maps, json).bufferView].byteLength = 60),
    /texture \d: not a readable image, got "truncated file"/,
  ],
  [
    'an image that cannot be decoded',
    (maps, json) => {
      delete normals(maps, json).bufferView
      normals(maps, json).uri = 'data:image/png;base64,AAAA'
    },
    /texture \d: not a readable image, got "3 bytes"/,
  ],
  [
    'an image that is not there',
    (maps, json) => {
      delete normals(maps, json).bufferView
      normals(maps, json).uri = '/no/such/image.png'
    },
    /texture \d: image cannot be fetched, got "\/no\/such\/image.png"; check that the server/,
  ],
  [
    'an image that is too large',
    (maps, json) => {
      delete normals(maps, json).bufferView
      normals(maps, json).uri = uris.large
    },
    /texture \d: image too large, got "8193 x 1"/,
  ],
  [
    'a slice of an image',
    (maps) => (maps.layers[0].normalTexture.slice = 0),
    /a slice of an image that is not KTX 2/,
  ],
  [
    'layers of different sizes',
    (maps, json) => {
      const other = maps.layers[0].normalTexture.index
      maps.layers.push({ name: 'more', normalTexture: { index: json.textures.length } })
      json.images.push({ uri: uris.small, mimeType: 'image/png' })
      json.textures.push({ ...json.textures[other], source: json.images.length - 1 })
    },
    /FURROW_wrinkle_maps: normal maps differ in size, got "16 x 16, 2 x 2"/,
  ],
]

describe.each(RENDERERS)('a damaged file on %s', (name) => {
  const harness = harnessOn(name)

  const load = (file: Uint8Array) => loadFile(harness, file)
  const picture = ({ scene }: GLTF) => litPicture(harness, scene)
  const textureCount = () => (harness.renderer as WebGLRenderer).info.memory.textures

  it.each(DAMAGES)('with %s shows the plain face and one warning', async (_, spoil, warning) => {
    const file = await spoiled(spoil)
    const plain = await new GLTFLoader().parseAsync(file.slice().buffer, '')
    const expected = await picture(plain)
    const before = textureCount()
    await picture(await new GLTFLoader().parseAsync(file.slice().buffer, ''))
    const ofPlain = textureCount() - before
    const gltf = await load(file)
    expect(written.warn.mock.calls).toEqual([[expect.stringMatching(warning)]])
    expect(written.warn.mock.calls[0][0]).toMatch(
      /^[\w ]+: .+; .+ \(material "skin" is shown without wrinkles\)$/,
    )
    expect(wrinklesOf(gltf)).toEqual([])
    expect(gltf.userData.wrinkles).toEqual([])
    expect(await picture(gltf)).toEqual(expected)
    expect(textureCount() - before).toBe(2 * ofPlain)
    const error = await readWrinkleMaps(gltf).catch((caught) => caught)
    expect(error).toBeInstanceOf(FurrowError)
  })

  it('does not affect other faces', async () => {
    const file = await wrinkledFile(undefined, (json) => {
      const [skin] = json.materials
      const damaged = structuredClone(skin)
      damaged.name = 'damaged'
      damaged.extensions.FURROW_wrinkle_maps.layers[0].normalTexture.index = 99
      json.materials.push(damaged)
      const twin = structuredClone(json.meshes[0])
      for (const primitive of twin.primitives) primitive.material = json.materials.length - 1
      json.meshes.push(twin)
      json.nodes.push({ ...json.nodes[0], name: 'twin', mesh: 1 })
      json.scenes[0].nodes.unshift(json.nodes.length - 1)
    })
    const gltf = await load(file)
    expect(written.warn.mock.calls).toEqual([
      [expect.stringMatching(/material "damaged" is shown without wrinkles/)],
    ])
    expect(wrinklesOf(gltf).map(({ mesh }) => mesh.parent!.name)).toEqual(['face'])
  })

  it('with an unlit material loads, and its faces with lit materials wrinkle', async () => {
    const file = await wrinkledFile(undefined, (json) => {
      const unlit = structuredClone(json.materials[0])
      unlit.name = 'unlit'
      unlit.extensions.KHR_materials_unlit = {}
      json.extensionsUsed.push('KHR_materials_unlit')
      json.materials.push(unlit)
      json.meshes[0].primitives[1].material = 1
    })
    const gltf = await load(file)
    expect(written.warn).toHaveBeenCalledTimes(1)
    expect(written.warn.mock.calls[0][0]).toMatch(/MeshBasicMaterial/)
    const [face] = wrinklesOf(gltf)
    face.mesh.morphTargetInfluences![0] = 1
    await picture(gltf)
    expect(face.getActivation('a')).toBe(1)
  })

  it.each<[string, unknown, RegExp]>([
    ['no type', { area: 'b' }, /drivers\[1\].type must be text, got nothing/],
    ['an unknown area', driver('nose', 'browInnerUp'), /drivers\[1\].area is unknown, got "nose"/],
    ['null', null, /drivers\[1\] must be an object, got null/],
  ])('loses only a driver that has %s', async (_, broken, warning) => {
    const gltf = await load(await wrinkledFile((json) => json.drivers.push(broken)))
    expect(written.warn.mock.calls).toEqual([[expect.stringMatching(warning)]])
    const [face] = wrinklesOf(gltf)
    face.mesh.morphTargetInfluences![0] = 1
    await picture(gltf)
    expect(face.getActivation('a')).toBe(1)
  })

  it('logs one warning for all broken drivers', async () => {
    const broken = Array.from({ length: 300 }, () => ({ area: 'b' }))
    await load(await wrinkledFile((json) => json.drivers.push(...broken)))
    expect(written.warn.mock.calls).toEqual([
      [expect.stringMatching(/drivers\[1\]\.type .* \(299 more are malformed; the other drivers work\)$/)],
    ])
  })

  it('loses only its drivers if they are not a list', async () => {
    const gltf = await load(await spoiled((maps) => (maps.drivers = { 0: 'morph' })))
    expect(written.warn.mock.calls).toEqual([[expect.stringMatching(/drivers must be an array/)]])
    expect(wrinklesOf(gltf)[0].getActivation('b')).toBe(0.25)
  })

  it.each<[string, (json: Animated) => unknown, RegExp]>([
    ['an unknown sampler', (json) => (json.channels[1].sampler = 9), /missing sampler, got 9/],
    ['an unknown accessor', (json) => (json.samplers[1].output = 99), /accessor counts/],
    [
      'an accessor that claims to be huge',
      (json) =>
        (json.accessors[json.samplers[1].output] = { componentType: 5126, type: 'SCALAR', count: 1e9 }),
      /accessor counts, got "3 and 1000000000"/,
    ],
    [
      'too few activations',
      (json) => (json.accessors.at(-1)!.count = 2),
      /of different lengths, got "3 and 2"/,
    ],
    [
      'times as activations of another',
      (json) => (json.samplers[1].input = json.samplers[0].output),
      /increase/,
    ],
    [
      'an accessor outside of its data',
      (json) => (json.accessors.at(-1)!.byteOffset = 4000),
      /unreadable accessors/,
    ],
  ])('loses only the animation of an area by %s', async (_, spoil, warning) => {
    const file = await wrinkledFile(undefined, (json) => animate(json, spoil))
    const gltf = await load(file)
    expect(written.warn.mock.calls).toEqual([[expect.stringMatching(warning)]])
    expect(gltf.animations[0].tracks).toHaveLength(1)
    expect(wrinklesOf(gltf)).toHaveLength(1)
  })
})

interface Animated {
  accessors: { count: number; byteOffset?: number; componentType?: number; type?: string }[]
  channels: { sampler: number }[]
  samplers: { input: number; output: number }[]
}

/** Adds an animation of the first two areas, and damages it. */
// biome-ignore lint/suspicious/noExplicitAny: the complete JSON of a file
function animate(json: any, spoil: (json: Animated) => unknown): void {
  const add = (...values: number[]) => {
    const bytes = new Uint8Array(Float32Array.from(values).buffer)
    const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`
    const buffer = json.buffers.push({ uri, byteLength: bytes.length }) - 1
    const bufferView = json.bufferViews.push({ buffer, byteLength: bytes.length }) - 1
    return json.accessors.push({ bufferView, componentType: 5126, type: 'SCALAR', count: values.length }) - 1
  }
  const input = add(0, 1, 2)
  const samplers = [add(1, 0.5, 0), add(0, 1, 0)].map((output) => ({ input, output }))
  const channels = samplers.map((_, sampler) => {
    const pointer = `/materials/0/extensions/FURROW_wrinkle_maps/areas/${sampler}/activation`
    return { sampler, target: { path: 'pointer', extensions: { KHR_animation_pointer: { pointer } } } }
  })
  json.extensionsUsed.push('KHR_animation_pointer')
  json.animations = [{ samplers, channels }]
  spoil({ accessors: json.accessors, channels, samplers })
}

describe('a file of KTX 2 arrays', () => {
  it.each<[string, Spoil, RegExp]>([
    [
      'cut off',
      (maps, json) => {
        const { extensions } = json.textures[maps.layers[0].normalTexture.index]
        const { bufferView } = json.images[extensions.KHR_texture_basisu.source]
        json.bufferViews[bufferView].byteLength = 400
      },
      /FURROW_wrinkle_maps texture \d+: truncated file, got "400 bytes"/,
    ],
    ['without the slice', (maps) => (maps.areas[0].texture.slice = 40), /no such slice, got 40/],
    [
      'without an image',
      (maps, json) => (json.textures[maps.areas[0].texture.index].extensions = { KHR_texture_basisu: {} }),
      /a slice of an image that is not KTX 2/,
    ],
  ])('that is %s shows the plain face and one warning', async (_, spoil, warning) => {
    const harness = await createHarness('webgl')
    onTestFinished(() => harness.dispose())
    const bytes = new Uint8Array(await (await fetch('/packed/arrays.glb')).arrayBuffer())
    const file = editGlb(bytes, (json) => {
      const [material] = json.materials.filter((own: { extensions?: object }) => own.extensions)
      spoil(material.extensions.FURROW_wrinkle_maps, json)
    })
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js')
    const ktx2 = new KTX2Loader()
      .setTranscoderPath('/node_modules/three/examples/jsm/libs/basis/')
      .detectSupport(harness.renderer)
    onTestFinished(() => void ktx2.dispose())
    const loader = new GLTFLoader().setKTX2Loader(ktx2).setMeshoptDecoder(MeshoptDecoder)
    const gltf = await loader
      .register((parser) => new WrinkleLoaderPlugin(parser))
      .parseAsync(file.buffer, '')
    expect(written.warn.mock.calls).toEqual([[expect.stringMatching(warning)]])
    expect(wrinklesOf(gltf)).toEqual([])
    expect(gltf.scene.getObjectsByProperty('isMesh', true)).not.toEqual([])
  })
})

import { readFileSync } from 'node:fs'
import { checkTriangles, costProblem } from 'furrow-files'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { decodingProblem } from '../../../packages/files/src/checks/document.ts'
import { shapeProblem } from '../../../packages/files/src/checks/shape.ts'
import { checkContentSize } from '../../../packages/files/src/ktx2/zstd-frame.ts'
import { flatPng } from '../../fuzz/damage-images.ts'
import { type Anything, joinGlb, setImage, splitGlb } from '../../fuzz/glb-parts.ts'
import { editGlb, jsonOf } from '../../glb.ts'
import { sheet, sheetGlb } from './sheet.ts'
import { faceBytes, Workshop } from './workshop.ts'

const shop = new Workshop()
let face: Buffer
let folder = ''

beforeAll(async () => {
  face = Buffer.from(await faceBytes())
  folder = await shop.makeFolder('face')
  await shop.run('pack', folder, '-o', shop.path('packed.glb'))
})

const FILE_BYTES = 4000

/** Changes the JSON of the face, and returns the problem that the checks find. */
function problem(change: (json: Anything) => unknown): string | undefined {
  const json = jsonOf(face)
  change(json)
  const binary = splitGlb(face).bin.length
  return shapeProblem(json) ?? costProblem(json, FILE_BYTES) ?? decodingProblem(json, binary)
}

const chain = (length: number) => (json: Anything) => {
  const first = json.nodes.length
  for (let i = 1; i < length; i++) json.nodes.push({ children: [first + i] })
  json.nodes.push({})
}

const sparse = (count: number) => ({
  count,
  indices: { bufferView: 0, componentType: 5123 },
  values: { bufferView: 0 },
})

const compress = (json: Anything, how: object) =>
  Object.assign(json.bufferViews[0], {
    extensions: { EXT_meshopt_compression: { buffer: 0, byteLength: 4, ...how } },
  })

describe('numbers are checked before anything is decoded', () => {
  it('accepts an intact face', () => {
    expect(problem(() => {})).toBeUndefined()
  })

  const mesh = ({ meshes }: Anything) => meshes[0].primitives[0]
  /** Adds a primitive to the mesh several times. */
  const repeat = (json: Anything, times: number, primitive: object) =>
    json.meshes[0].primitives.push(...Array(times).fill(primitive))
  const claim = (json: Anything, componentType: number, type: string, count: number) =>
    json.accessors.push({ componentType, type, count }) - 1

  it.each<[string, (json: Anything) => unknown, string]>([
    ['a sparse count of a billion', ({ accessors: [a] }) => (a.sparse = sparse(1e9)), 'accessors[0]'],
    [
      'a sparse offset beyond',
      ({ accessors: [a] }) => (a.sparse = { ...sparse(1), values: { bufferView: 0, byteOffset: 1e6 } }),
      'accessors[0].sparse.values',
    ],
    ['a stride of half a byte', ({ bufferViews: [v] }) => (v.byteStride = 0.5), 'bufferViews[0]'],
    [
      'a stride of 1',
      (json) => (json.bufferViews[json.accessors[0].bufferView].byteStride = 1),
      'accessors[0]',
    ],
    ['a count of 1e308', ({ accessors: [a] }) => (a.count = 1e308), 'accessors[0]'],
    ['a count beyond the view', ({ accessors: [a] }) => (a.count = 4000), 'accessors[0]'],
    ['a count of zeros without a view', (json) => claim(json, 5126, 'VEC3', 1e8), 'decode to 1201 MB'],
    ['a component type', ({ accessors: [a] }) => (a.componentType = 5124), 'component type 5124'],
    [
      'integers of 32 bits that are normalized',
      ({ accessors: [a] }) => Object.assign(a, { componentType: 5125, normalized: true }),
      'accessors[0] has normalized 32-bit integers',
    ],
    [
      'an offset that is not aligned',
      ({ accessors: [a] }) => Object.assign(a, { byteOffset: 2, count: 1 }),
      'aligned',
    ],
    ['a view beyond the buffer', ({ bufferViews: [v] }) => (v.byteLength = 1e9), 'bufferViews[0]'],
    [
      'a view of a buffer without bytes',
      ({ buffers, bufferViews: [v] }) => (v.buffer = buffers.push({ byteLength: 99 }) - 1),
      'bufferViews[0]',
    ],
    [
      'many triangles of few bytes',
      (json) =>
        repeat(json, 1000, { attributes: mesh(json).attributes, indices: claim(json, 5125, 'SCALAR', 4500) }),
      'triangles',
    ],
    [
      'many primitives of one accessor',
      (json) =>
        repeat(json, 5000, { attributes: { POSITION: claim(json, 5126, 'VEC3', 30_000) }, indices: 0 }),
      'decode to',
    ],
    ['a chain of 20,000 nodes', chain(20_000), 'more than 256 ancestors'],
    ['a node that is its own child', ({ nodes }) => (nodes[0].children = [0]), 'own ancestors'],
    [
      'a node with two parents',
      ({ nodes }) => nodes.push({ children: [0] }, { children: [0] }),
      'two parents',
    ],
    [
      'a mesh that does not exist',
      ({ nodes }) => (nodes[0].mesh = 9),
      'nodes[0].mesh is 9, but the list has 2 items',
    ],
    [
      'an accessor that does not exist',
      (json) => (mesh(json).targets[0].NORMAL = 99),
      'targets[0].NORMAL is 99',
    ],
    [
      'a texture that does not exist',
      ({ materials }) => (materials[0].normalTexture.index = 99),
      'normalTexture.index is 99',
    ],
    ['an image that does not exist', ({ textures }) => (textures[0].source = 99), 'textures[0].source is 99'],
    ['a texture without an image', (json) => delete json.textures[0].source, 'textures[0] has no image'],
    [
      'a compressed view without a count',
      (json) => compress(json, { byteStride: 4, mode: 'ATTRIBUTES' }),
      'bufferViews[0] is malformed',
    ],
    [
      'a mode that no decoder has',
      (json) => compress(json, { count: 1, byteStride: 4, mode: 'MAT4' }),
      'bufferViews[0] is malformed',
    ],
    [
      'a Draco attribute that its primitive does not have',
      (json) =>
        (mesh(json).extensions = {
          KHR_draco_mesh_compression: { bufferView: 0, attributes: { COLOR_0: 0 } },
        }),
      'meshes[0].primitives[0] lists COLOR_0 only in its Draco extension',
    ],
    [
      'an extension that is required and not listed',
      (json) => (json.extensionsRequired = ['EXT_meshopt_compression']),
      'the required extension EXT_meshopt_compression is missing in extensionsUsed',
    ],
    ['a root that does not exist', ({ scenes }) => scenes[0].nodes.push(99), 'scenes[0].nodes is 99'],
  ])('names %s', (_, change, message) => {
    expect(problem(change)).toContain(message)
  })

  it('accepts node chains as deep as skeletons', () => {
    expect(problem(chain(200))).toBeUndefined()
  })

  it("accepts zstandard data only of the size given by the image's header", () => {
    // Header of a Zstandard frame that declares its decoded size in four bytes (RFC 8878, 3.1.1.1).
    const frame = Uint8Array.of(0x28, 0xb5, 0x2f, 0xfd, 0xa0, 0, 0, 0, 0x40, ...Array(16).fill(0))
    expect(() => checkContentSize(frame, 2 ** 30)).not.toThrow()
    expect(() => checkContentSize(frame, 64)).toThrow('it has 1073741824 bytes instead of 64')
  })
})

describe('commands refuse in one line', () => {
  const out = ['-o', shop.path('out.glb')]

  it.each(['[', '{"a":'])('JSON nested 6,000 deep (%s)', async (open) => {
    const close = open === '[' ? ']' : '}'
    const parts = splitGlb(readFileSync(shop.path('packed.glb')))
    parts.json.extras = 'deep'
    const deep = open.repeat(6000) + (open === '[' ? '' : '1') + close.repeat(6000)
    const path = shop.write('deep.glb', joinGlb(parts, JSON.stringify(parts.json).replace('"deep"', deep)))
    await shop.fails('more than 128 levels deep', 'unpack', path, '-o', shop.path('unpacked'))
  })

  it('a mesh without vertices in bake', async () => {
    const empty = shop.write(
      'empty.glb',
      editGlb(face, ({ accessors }) => {
        for (const accessor of accessors) accessor.count = 0
      }),
    )
    const intact = shop.write('face.glb', face)
    for (const files of [
      [intact, empty],
      [empty, intact],
    ])
      await shop.fails('no triangles', 'bake', ...files, '-o', shop.path('out.png'))
  })

  it('few triangles or blendshapes that are listed many times', async () => {
    const { json, bin } = splitGlb(Buffer.from(await sheetGlb(sheet(16))))
    const { primitives } = json.meshes[0]
    const hostile = (times: number, targets: number) => {
      const primitive = { ...primitives[0], targets: Array(targets).fill(primitives[0].targets[0]) }
      const mesh = { name: 'hostile', primitives: Array(times).fill(primitive) }
      return shop.write('hostile.glb', joinGlb({ json: { ...json, meshes: [mesh] }, bin }))
    }
    const onTop = 'too many overlapping triangles in UV space'
    await shop.fails(onTop, 'auto', hostile(400, 1), ...out)
    const product = 'the mesh "hostile" has too many triangles times blendshapes'
    await shop.fails(product, 'auto', hostile(20, 1200), ...out)
  })

  it('too many triangles times blendshapes for the size of the file', async () => {
    const json = jsonOf(Buffer.from(await sheetGlb(sheet(4))))
    const [primitive] = json.meshes[0].primitives
    primitive.targets = Array(15).fill(primitive.targets[0])
    json.accessors[primitive.indices].count = 3 * 800_000
    const check = (fileBytes: number) => () =>
      checkTriangles({ json, fileBytes } as Parameters<typeof checkTriangles>[0], 'test')
    expect(check(800_000)).toThrow('the mesh "torso" has too many triangles times blendshapes')
    expect(check(8_000_000)).not.toThrow()
  })

  it('images in unsupported formats, which their first bytes reveal', async () => {
    const svg = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="64" height="64"/>')
    const gif = await sharp(flatPng(64, 64)).gif().toBuffer()
    const message = 'unsupported image format'
    const png = ['-o', shop.path('out.png')]
    for (const bytes of [svg, gif]) {
      await shop.fails(message, 'normals', shop.write('height.png', bytes), ...png, '--strength', '4')
      const parts = setImage(splitGlb(readFileSync(shop.path('packed.glb'))), 4, bytes)
      const packed = shop.write('other.glb', joinGlb(parts))
      await shop.fails(message, 'unpack', packed, '-o', shop.path('unpacked'))
      await shop.fails(message, 'inspect', packed, '--sheet', shop.path('out.png'))
    }
  })

  it('a corrupt image, with its name', async () => {
    const parts = splitGlb(readFileSync(shop.path('packed.glb')))
    const { bufferView, name } = parts.json.images[4]
    const { byteOffset, byteLength } = parts.json.bufferViews[bufferView]
    parts.bin.fill(0, byteOffset + 60, byteOffset + byteLength)
    const path = shop.write('corrupt.glb', joinGlb(parts))
    await shop.fails(name, 'unpack', path, '-o', shop.path('unpacked'))
  })
})

import { readFileSync } from 'node:fs'
import type { RgbaImage } from 'furrow'
import { readWrinkleMaps, Wrinkles } from 'furrow/three'
import { checkWrinkles, decodeGlb } from 'furrow-files'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { afterAll, beforeAll, expect, it, vi } from 'vitest'
import { Random } from '../../fuzz/random.ts'
import { jsonOf, withJson } from '../../glb.ts'
import { noise } from '../../noise.ts'
import { mutate } from '../gltf/mutations.ts'
import { loadInNode } from '../three/node-loader.ts'
import { Workshop } from './workshop.ts'

// Furrow reads the pixels of an ImageBitmap with WebGL, which Node lacks. In this test, the bitmap is an object with pixels.
vi.mock(import('../../../packages/furrow/src/runtime/file/read-image.ts'), async (original) => ({
  ...(await original()),
  readImage: (bitmap) => bitmap as unknown as RgbaImage,
}))

const NAME = 'FURROW_wrinkle_maps'
const FILES = 600
const shop = new Workshop()
const bases: Uint8Array[] = []

type Json = ReturnType<typeof jsonOf>

const STROKE = {
  points: [
    [0, 0.5],
    [0.25, 0.75],
  ],
  width: 4,
  depth: 0.5,
}

beforeAll(async () => {
  const folder = await shop.makeFolder('face')
  const strokes = ['age', 'expression'].map((layer) => ({ ...STROKE, layer }))
  shop.json('face/strokes.json', { version: 1, strokes })
  shop.write('face/layers/age/blood.png', await noise(5))
  shop.write('face/layers/age/occlusion.png', await noise(6))
  shop.json('face/wrinkles.json', { layers: [{ name: 'age', bloodAmplitude: 0.5 }, { name: 'expression' }] })
  for (const args of [[], ['--ktx2']]) {
    await shop.run('pack', folder, '-o', shop.path('base.glb'), ...args)
    bases.push(readFileSync(shop.path('base.glb')))
  }
})
afterAll(() => vi.unstubAllGlobals())

const JUNK = [
  null,
  0,
  1,
  -1,
  1.5,
  7,
  99,
  '',
  'brow',
  [],
  {},
  { index: 0 },
  { index: 3 },
  { index: 2, slice: 0 },
]

/** Returns the textures of the wrinkles. They follow the four textures of the face. */
const own = (textures: Json[]) => textures.slice(4)

/** Changes of JSON that is outside the extension. They may make the maps of the extension unreadable. */
const AROUND: ((json: Json, random: Random) => unknown)[] = [
  (json) => delete json.extensionsUsed,
  (json, random) => Object.assign(random.pick<Json>(own(json.textures)), { source: random.int(12) }),
  (json, random) => delete random.pick<Json>(own(json.textures)).source,
  (json, random) => delete random.pick<Json>(own(json.textures)).extensions,
  (json, random) => Object.assign(random.pick<Json>(own(json.textures)), { extensions: { KHR_texture_basisu: { source: random.int(9) } } }),
  (json, random) => Object.assign(random.pick<Json>(json.images), { bufferView: random.int(20) }),
  (json, random) => Object.assign(random.pick<Json>(json.images), { mimeType: 'image/webp' }),
  (json) => Object.assign(json.materials[0].extensions, { KHR_materials_unlit: {} }),
  (json, random) => delete json.meshes[0].primitives[0].attributes[random.pick(['NORMAL', 'TEXCOORD_0'])],
  (json) => Object.assign(json.materials[0].normalTexture, { index: json.textures.length - 1 }),
] // biome-ignore format: one line each

/** Makes a file that is damaged in the extension, in other JSON, or in the bytes of an image of the wrinkles. */
function damaged(seed: number): Uint8Array {
  const random = new Random(seed)
  const base = random.pick(bases)
  const json = jsonOf(base)
  const kind = random.int(10)
  if (kind < 4) {
    const actions = ['replace', 'remove', 'double', 'swap', 'nest', 'rename'] as const
    const mutation = { node: random.int(300), action: random.pick(actions), junk: random.pick(JUNK) }
    json.materials[0].extensions[NAME] = mutate(json.materials[0].extensions[NAME], mutation)
  } else if (kind < 6) random.pick(AROUND)(json, random)
  const bytes = Buffer.from(withJson(base, json))
  if (kind >= 6) damageImage(bytes, json, random)
  return bytes
}

function damageImage(bytes: Buffer, json: Json, random: Random): void {
  // The last three images belong to the wrinkles.
  const views = json.images.slice(-3).map(({ bufferView }: Json) => json.bufferViews[bufferView])
  const { byteOffset = 0, byteLength } = random.pick<Json>(views)
  const start = bytes.length - json.buffers[0].byteLength + byteOffset
  const image = bytes.subarray(start, start + byteLength)
  const action = random.int(4)
  if (action === 0) image.fill(0, random.int(byteLength))
  else if (action === 1) image[random.int(Math.min(byteLength, 120))] = random.int(256)
  else if (action === 2) image[random.int(byteLength)] ^= 1 << random.int(8)
  else image.copyWithin(0, random.int(byteLength))
}

/** Returns the error of `furrow validate`; undefined if it accepts the file. */
async function validateError(bytes: Uint8Array): Promise<string | undefined> {
  try {
    const findings = await checkWrinkles(decodeGlb(Buffer.from(bytes), 'x.glb', 'test'))
    return findings.find(({ severity }) => severity === 'error')?.message
  } catch (error) {
    expect((error as Error).name).toBe('FurrowError')
    return (error as Error).message
  }
}

/** Returns why the loader refuses the wrinkles of a face; undefined if it accepts them. */
async function loaderError(gltf: GLTF): Promise<string | undefined> {
  try {
    for (const { meshes, set } of await readWrinkleMaps(gltf)) {
      new Wrinkles(meshes[0], set).dispose()
    }
    return undefined
  } catch (error) {
    return String((error as Error)?.message)
  }
}

it(`validate and the loader refuse the same wrinkles, in ${FILES} damaged files`, async () => {
  vi.spyOn(console, 'warn').mockImplementation(() => {})
  let refused = 0
  const differing: string[] = []
  for (let seed = 0; seed < FILES; seed++) {
    const bytes = damaged(seed)
    const gltf = await loadInNode(bytes).catch(() => undefined)
    // Skips files that three.js itself refuses, because their errors are outside the wrinkles.
    if (!gltf) continue
    const [validate, loader] = [await validateError(bytes), await loaderError(gltf)]
    if (validate !== undefined) refused++
    if ((validate === undefined) !== (loader === undefined)) {
      differing.push(`${seed}: validate: ${validate ?? 'yes'}; loader: ${loader ?? 'yes'}`)
    }
  }
  expect(differing).toEqual([])
  // Many files must be refused and many accepted; otherwise the agreement proves nothing.
  expect(refused).toBeGreaterThan(FILES / 4)
  expect(refused).toBeLessThan((FILES * 3) / 4)
})

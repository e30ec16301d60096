import type { WrinkleDriver } from 'furrow'
import {
  type Compression,
  checkWrinkles,
  decodeGlb,
  embedWrinkles,
  encodeGlb,
  type Glb,
  writeArray,
} from 'furrow-files'
import sharp, { type Sharp } from 'sharp'
import { BufferViewWriter } from '../../packages/files/src/gltf/buffer-view-writer.ts'
import type { FileImage, LayerImages } from '../../packages/files/src/pack/embed.ts'
import { damageBytes } from '../fuzz/damage-bytes.ts'
import { damageHeader, damageKtx2, flatPng } from '../fuzz/damage-images.ts'
import { Random } from '../fuzz/random.ts'
import { seeded } from '../random.ts'
import { wrinkledFile } from './wrinkled-file.ts'

const FILES = 150
const SIDE = 32
const NAME = 'FURROW_wrinkle_maps'
const LAYERS = ['age', 'expression']

/** File that may contain damaged wrinkles, and the result of `furrow validate`. */
export interface DamagedFace {
  name: string
  /** Bytes of the `.glb`, base64. */
  file: string
  /** First error; null if the file is valid. */
  problem: string | null
  /** True for AVIF images. AV1 has no checksums, so browsers may decode damaged data that libraries refuse. */
  isUnsure: boolean
}

type Encode = (image: Sharp) => Sharp

/** MIME type and encoder of each image format that users store. */
const FORMATS: Record<string, [mimeType: string, encode: Encode]> = {
  png: ['image/png', (image) => image.png()],
  'png with palette': ['image/png', (image) => image.png({ palette: true })],
  'png of 16 bits': ['image/png', (image) => image.toColourspace('rgb16').png()],
  'interlaced png': ['image/png', (image) => image.png({ progressive: true })],
  jpeg: ['image/jpeg', (image) => image.jpeg()],
  'progressive jpeg': ['image/jpeg', (image) => image.jpeg({ progressive: true })],
  webp: ['image/webp', (image) => image.webp()],
  'lossless webp': ['image/webp', (image) => image.webp({ lossless: true })],
  avif: ['image/avif', (image) => image.avif({ lossless: true })],
}

/** Makes one undamaged file per image format. The keys are names of formats. */
export async function intactFaces(): Promise<Map<string, Uint8Array>> {
  const faces = new Map<string, Uint8Array>()
  for (const [name, [mimeType, encode]] of Object.entries(FORMATS)) {
    const image = async (seed: number): Promise<FileImage> => {
      const raw = { width: SIDE, height: SIDE, channels: 3 as const }
      const bytes = await encode(sharp(pixels(seed, 3), { raw })).toBuffer()
      return { name: `${name} ${seed}`, mimeType, bytes }
    }
    faces.set(name, await face([await image(1), await image(2)], [await image(3)]))
  }
  for (const compression of ['uastc', 'etc1s'] as const) {
    const [normals, areas] = [await array(compression, [1, 2], true), await array(compression, [3, 4], false)]
    const images = [await plainKtx2(compression, 1), await plainKtx2(compression, 2)]
    faces.set(`${compression} arrays`, await face(slices(normals), slices(areas)))
    faces.set(`${compression} images`, await face(images, [await plainKtx2(compression, 3)]))
    faces.set(`${compression} images and an array`, await face(images, slices(areas)))
  }
  return faces
}

/** Returns the undamaged files of all formats, followed by variants with one damaged image. */
export async function damagedFaces(): Promise<DamagedFace[]> {
  const intact = [...(await intactFaces())]
  const faces = await Promise.all(intact.map(([name, bytes]) => validated(name, bytes)))
  for (let seed = 0; seed < FILES; seed++) {
    const [name, original] = intact[seed % intact.length]!
    const { bytes, how } = damage(original, new Random(seed))
    faces.push(await validated(`${seed}: ${name}, ${how}`, bytes))
  }
  return faces
}

async function validated(name: string, bytes: Uint8Array): Promise<DamagedFace> {
  const findings = await checkWrinkles(decodeGlb(Buffer.from(bytes), 'face.glb', 'test'))
  const error = findings.find(({ severity }) => severity === 'error')
  return {
    name,
    file: Buffer.from(bytes).toString('base64'),
    problem: error?.message ?? null,
    isUnsure: name.includes('avif'),
  }
}

type Damage = (image: Buffer, random: Random) => Buffer

const DAMAGES: Record<string, Damage> = {
  'cut off': (image, random) => image.subarray(0, random.int(image.length)),
  'cut off at its end': (image, random) => image.subarray(0, image.length - 1 - random.int(16)),
  'zero from somewhere on': (image, random) => Buffer.from(image).fill(0, random.int(image.length)),
  'one bit flipped': (image, random) => {
    const bytes = Buffer.from(image)
    bytes[random.int(bytes.length)]! ^= 1 << random.int(8)
    return bytes
  },
  'some bytes changed': damageBytes,
  'header changed': randomFirst(damageHeader),
  'replaced by another file': (_, random) => random.pick(OTHERS),
}

const OTHERS = [
  Buffer.alloc(0),
  Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="32" height="32"/>'),
  Buffer.from('R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7', 'base64'),
  flatPng(8193, 1),
  flatPng(64, 64),
]

function damage(original: Uint8Array, random: Random): { bytes: Uint8Array; how: string } {
  const glb = decodeGlb(Buffer.from(original), 'face.glb', 'test')
  const images = glb.json.images!.filter(({ name }) => name !== undefined)
  const image = random.pick(images)
  const { byteOffset = 0, byteLength } = glb.json.bufferViews![image.bufferView!]
  const before = Buffer.from(glb.bin.subarray(byteOffset, byteOffset + byteLength))
  const damages =
    image.mimeType === 'image/ktx2'
      ? { ...DAMAGES, 'KTX 2 fields changed': randomFirst(damageKtx2) }
      : DAMAGES
  const how = random.pick(Object.keys(damages))
  const writer = new BufferViewWriter(glb)
  image.bufferView = writer.add((damages as typeof DAMAGES)[how]!(before, random))
  writer.finish()
  return { bytes: encodeGlb(glb), how: `${image.name}: ${how}` }
}

function randomFirst(change: (random: Random, original: Buffer) => Buffer): Damage {
  return (image, random) => change(random, image)
}

/** Returns uniform noise of all byte values. */
function pixels(seed: number, channels: 3 | 4): Uint8Array {
  const next = seeded(seed)
  return Uint8Array.from({ length: SIDE * SIDE * channels }, () => Math.floor(256 * next()))
}

async function array(compression: Compression, seeds: number[], mipmaps: boolean): Promise<FileImage> {
  const names = seeds.map((seed) => `layer-${seed}`)
  const layers = seeds.map((seed) => pixels(seed, 4))
  const contents = { width: SIDE, height: SIDE, channels: 4 as const, srgb: false, names, layers }
  const bytes = await writeArray(contents, compression, mipmaps)
  return { name: `${compression} ${seeds}`, mimeType: 'image/ktx2', bytes }
}

async function plainKtx2(compression: Compression, seed: number): Promise<FileImage> {
  const image = await array(compression, [seed], true)
  const bytes = Buffer.from(image.bytes)
  // A `layerCount` of 0 makes this a single image instead of an array with one slice.
  bytes.writeUInt32LE(0, 32)
  return { ...image, bytes }
}

const slices = (image: FileImage) => [0, 1].map((slice) => ({ ...image, slice }))

/** Makes a face with a layer per normal map, and an area per channel of the area images. */
async function face(normals: FileImage[], areas: FileImage[]): Promise<Uint8Array> {
  const glb: Glb = decodeGlb(Buffer.from(await wrinkledFile()), 'face.glb', 'test')
  const material = glb.json.materials![0]!
  delete material.extensions![NAME]
  for (const image of glb.json.images!) delete image.name
  embedWrinkles(
    glb,
    0,
    {
      layers: normals.map((normal, i): LayerImages => ({ name: LAYERS[i]!, kind: 'replace', normal })),
      areas: areas.flatMap((image, i) =>
        [0, 1, 2].map((channel) => ({ name: `${i} ${channel}`, image, channel, layer: channel % 2 })),
      ),
      drivers: [] as WrinkleDriver[],
    },
    'test',
  )
  nameFormats(glb)
  return encodeGlb(glb)
}

/** Adds to each texture the extension that glTF requires for its image format, such as `EXT_texture_webp`. */
function nameFormats({ json }: Glb): void {
  for (const texture of json.textures!) {
    const extension = FORMAT_EXTENSIONS[json.images![texture.source ?? 0]!.mimeType!]
    if (texture.source === undefined || !extension) continue
    texture.extensions = { [extension]: { source: texture.source } }
    delete texture.source
  }
}

const FORMAT_EXTENSIONS: Record<string, string | undefined> = {
  'image/webp': 'EXT_texture_webp',
  'image/avif': 'EXT_texture_avif',
  'image/ktx2': 'KHR_texture_basisu',
}

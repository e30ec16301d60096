import {
  ClampToEdgeWrapping,
  CompressedArrayTexture,
  type CompressedTexture,
  LinearFilter,
  NoColorSpace,
  REVISION,
  SRGBColorSpace,
} from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { type Ktx2Header, readKtx2Header } from '../../core/maps/ktx2-header.ts'
import type { TextureShape } from '../../core/maps/rules.ts'
import { fileError } from '../../runtime/file/file-error.ts'
import type { FileArrays } from '../../runtime/file/gltf-source.ts'
import type { ArrayTexture } from '../material/array-texture.ts'
import { requireInternal } from '../three-version.ts'
import { readImageBytes } from './image-bytes.ts'
import { joinArrays } from './join-arrays.ts'

interface LoaderOptions {
  ktx2Loader?: KTX2Loader | null
}

/** A `KTX2Loader` with undocumented internals of three.js. Code checks them with `requireInternal` before use. */
type Transcoder = KTX2Loader & {
  /** Formats supported by the GPU. */
  workerConfig: NonNullable<KTX2Loader['workerConfig']> | null
  transcoderPending: Promise<unknown> | null
  transcoderBinary?: ArrayBuffer
  workerSourceURL?: string
  workerPool?: { setWorkerCreator?(create: () => Worker): void; dispose?(): void }
  init?(): Promise<unknown>
}

/** Texture array from a KTX 2 file. A KTX 2 file with a single image becomes an array of one slice. */
interface Ktx2Texture {
  array: ArrayTexture
  header: Ktx2Header
}

/** Throws an error if an image of this shape must not be decoded. */
type ShapeCheck = (shape: TextureShape) => void

/** Returns a reader of the KTX 2 textures in a file that `GLTFLoader` loads. */
export function arraysOf(parser: GLTFParser): FileArrays {
  return {
    async load(index, use, check) {
      const loaded = await (use === 'areas' ? loadAreaArray : loadMapArray)(parser, index, check)
      // In glTF the use of a texture determines its colour space, regardless of the KTX 2 file.
      loaded.array.colorSpace = use === 'colours' ? SRGBColorSpace : NoColorSpace
      return loaded
    },
    join: joinArrays,
  }
}

/**
 * Loads the texture array of areas from a KTX 2 file. `KTX2Loader` chooses a compressed format that the GPU supports.
 *
 * @throws FurrowError if the loader has no `KTX2Loader`, or the texture is not a valid texture of KHR_texture_basisu.
 */
async function loadAreaArray(parser: GLTFParser, index: number, check: ShapeCheck): Promise<Ktx2Texture> {
  const file = await readFile(parser, index, check)
  const array = await transcode(file, ktx2LoaderOf(parser))
  // No mipmaps: in mipmaps, areas would bleed across the borders of UV islands. Areas are smooth enough without mipmaps.
  array.minFilter = LinearFilter
  return { array, header: file.header }
}

/**
 * Loads the texture array of layer maps from a KTX 2 file. If the GPU supports the format BC1, uses BC1 instead of BC7 to halve the memory.
 * For the visible difference see "Sizes" in docs/pack.md.
 *
 * @throws FurrowError as `loadAreaArray` does, or if `KTX2Loader` lacks a required internal.
 */
export async function loadMapArray(
  parser: GLTFParser,
  index: number,
  check: ShapeCheck,
): Promise<Ktx2Texture> {
  const file = await readFile(parser, index, check)
  const { header } = file
  const loader = ktx2LoaderOf(parser) as Transcoder
  const { workerConfig } = loader
  if (!workerConfig?.dxtSupported) return { array: await transcode(file, loader), header }
  const bc1Loader = await withFormats(loader, { ...workerConfig, ...BC1_TO_BC3 })
  try {
    return { array: await transcode(file, bc1Loader), header }
  } finally {
    bc1Loader.workerPool?.dispose?.()
  }
}

/** Settings of `KTX2Loader` that disable all formats except BC1 to BC3. */
const BC1_TO_BC3 = { astcSupported: false, bptcSupported: false, etc1Supported: false, etc2Supported: false }

/**
 * Creates a second loader that transcodes to other formats. Both loaders share the transcoder binary, because three.js warns if the binary is
 * fetched twice.
 */
async function withFormats(
  loader: Transcoder,
  workerConfig: Transcoder['workerConfig'],
): Promise<Transcoder> {
  await requireInternal(loader.init, WRINKLE_MAPS, 'KTX2Loader.init', REVISION).call(loader)
  const binary = requireInternal(
    loader.transcoderBinary,
    WRINKLE_MAPS,
    'KTX2Loader.transcoderBinary',
    REVISION,
  )
  const source = requireInternal(loader.workerSourceURL, WRINKLE_MAPS, 'KTX2Loader.workerSourceURL', REVISION)
  const other = new (loader.constructor as new () => Transcoder)()
  const { workerPool } = other
  const setWorkerCreator = requireInternal(
    workerPool?.setWorkerCreator,
    WRINKLE_MAPS,
    'KTX2Loader.workerPool.setWorkerCreator',
    REVISION,
  )
  other.transcoderPending = Promise.resolve()
  other.workerConfig = workerConfig
  setWorkerCreator.call(workerPool, () => {
    const worker = new Worker(source)
    worker.postMessage({ type: 'init', config: workerConfig, transcoderBinary: binary })
    return worker
  })
  return other
}

interface Ktx2File {
  bytes: Uint8Array<ArrayBuffer>
  header: Ktx2Header
  /** Name of the texture, for errors. */
  who: string
}

/** Reads the KTX 2 file of a texture, and checks its header before decoding. */
async function readFile(parser: GLTFParser, index: number, check: ShapeCheck): Promise<Ktx2File> {
  const who = `${WRINKLE_MAPS} texture ${index}`
  const { extensions } = parser.json.textures[index]
  const bytes = await readImageBytes(parser, extensions?.KHR_texture_basisu?.source, who)
  if (bytes) {
    const header = readKtx2Header(bytes, who)
    check(header)
    return { bytes, header, who }
  }
  throw new FurrowError({
    who,
    problem: 'the map is a slice of an image that is not KTX 2',
    limit: 'a texture with KHR_texture_basisu',
    remedy: 'pack the file again',
  })
}

async function transcode({ bytes, who }: Ktx2File, loader: KTX2Loader): Promise<ArrayTexture> {
  const url = URL.createObjectURL(new Blob([bytes]))
  try {
    const array = asArray(await loader.loadAsync(url))
    array.wrapS = array.wrapT = ClampToEdgeWrapping
    array.magFilter = LinearFilter
    return array
  } catch (error) {
    throw fileError(error, who, 'KTX 2 image cannot be decoded')
  } finally {
    URL.revokeObjectURL(url)
  }
}

/** Returns a texture array. Converts a 2D texture, which `KTX2Loader` returns if the array has one slice. */
function asArray(texture: CompressedTexture): CompressedArrayTexture {
  if ('isCompressedArrayTexture' in texture) return texture as CompressedArrayTexture
  const { mipmaps, format, type, minFilter, colorSpace } = texture
  const { width, height } = texture.image
  const array = new CompressedArrayTexture(mipmaps!, width, height, 1, format, type)
  array.minFilter = minFilter
  array.colorSpace = colorSpace
  array.needsUpdate = true
  return array
}

function ktx2LoaderOf(parser: GLTFParser): KTX2Loader {
  const { ktx2Loader } = parser.options as LoaderOptions
  if (ktx2Loader) return ktx2Loader
  throw new FurrowError({
    code: 'unsupported',
    who: WRINKLE_MAPS,
    problem: 'the loader cannot read KTX 2 maps',
    limit: 'a GLTFLoader with a KTX2Loader',
    remedy: 'call loader.setKTX2Loader(new KTX2Loader().setTranscoderPath(...).detectSupport(renderer))',
  })
}

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

/** A KTX2Loader with its internals, which three.js's types leave out and `requireInternal` guards. */
type Transcoder = KTX2Loader & {
  /** The formats that the GPU supports. */
  workerConfig: NonNullable<KTX2Loader['workerConfig']> | null
  transcoderPending: Promise<unknown> | null
  transcoderBinary?: ArrayBuffer
  workerSourceURL?: string
  workerPool?: { setWorkerCreator?(create: () => Worker): void; dispose?(): void }
  init?(): Promise<unknown>
}

/** A KTX 2 image or array of a file. A plain image is an array of one slice on the GPU. */
interface Ktx2Texture {
  array: ArrayTexture
  header: Ktx2Header
}

/** Throws where an image may not be decoded. */
type ShapeCheck = (shape: TextureShape) => void

/** Reads the KTX 2 images and arrays of a file that `GLTFLoader` loads. */
export function arraysOf(parser: GLTFParser): FileArrays {
  return {
    async load(index, use, check) {
      const loaded = await (use === 'areas' ? loadAreaArray : loadMapArray)(parser, index, check)
      // In glTF the use of a texture decides, not the colour space in its file.
      loaded.array.colorSpace = use === 'colours' ? SRGBColorSpace : NoColorSpace
      return loaded
    },
    join: joinArrays,
  }
}

/**
 * Loads the areas of a file, a KTX 2 image or array, in the best format that the GPU supports.
 *
 * @throws FurrowError when the loader has no KTX2Loader, or the image is not one that KHR_texture_basisu allows.
 */
async function loadAreaArray(parser: GLTFParser, index: number, check: ShapeCheck): Promise<Ktx2Texture> {
  const file = await readFile(parser, index, check)
  const array = await transcode(file, ktx2LoaderOf(parser))
  // Areas are smooth already, and mipmaps would bleed across UV islands.
  array.minFilter = LinearFilter
  return { array, header: file.header }
}

/**
 * Loads maps of a file's layers, a KTX 2 image or array, in half the memory where the GPU can: BC1 instead of BC7. Creases stay visible,
 * see "Sizes" in docs/pack.md.
 *
 * @throws FurrowError as `loadAreaArray` does, or when three.js's KTX2Loader lacks an internal that this needs.
 */
export async function loadMapArray(
  parser: GLTFParser,
  index: number,
  check: ShapeCheck,
): Promise<Ktx2Texture> {
  const file = await readFile(parser, index, check)
  const { header } = file
  const usual = ktx2LoaderOf(parser) as Transcoder
  const { workerConfig } = usual
  if (!workerConfig?.dxtSupported) return { array: await transcode(file, usual), header }
  const small = await withFormats(usual, { ...workerConfig, ...BC1_TO_BC3 })
  try {
    return { array: await transcode(file, small), header }
  } finally {
    small.workerPool?.dispose?.()
  }
}

/** Rules out all formats but BC1 to BC3. */
const BC1_TO_BC3 = { astcSupported: false, bptcSupported: false, etc1Supported: false, etc2Supported: false }

/**
 * A second loader that transcodes to other formats. It shares the transcoder: a loader of its own would fetch that again, of which
 * three.js warns.
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

/** A KTX 2 file of which only the header was read. */
interface Ktx2File {
  bytes: Uint8Array<ArrayBuffer>
  header: Ktx2Header
  /** The texture, for errors. */
  who: string
}

/** Reads the KTX 2 file of a texture, and checks its header before anything is decoded. */
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
    problem: 'a slice of an image that is not KTX 2',
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
    throw fileError(error, who, 'a KTX 2 image that cannot be decoded')
  } finally {
    URL.revokeObjectURL(url)
  }
}

/** `KTX2Loader` returns an array of one slice as a plain texture. */
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
    problem: 'the maps are KTX 2, which the loader cannot read',
    limit: 'a GLTFLoader with a KTX2Loader',
    remedy: 'call loader.setKTX2Loader(new KTX2Loader().setTranscoderPath(...).detectSupport(renderer))',
  })
}

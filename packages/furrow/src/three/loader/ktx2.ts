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

/** A KTX2Loader with internals that three.js's types omit; `requireInternal` guards their use. */
type Transcoder = KTX2Loader & {
  /** Formats supported by the GPU. */
  workerConfig: NonNullable<KTX2Loader['workerConfig']> | null
  transcoderPending: Promise<unknown> | null
  transcoderBinary?: ArrayBuffer
  workerSourceURL?: string
  workerPool?: { setWorkerCreator?(create: () => Worker): void; dispose?(): void }
  init?(): Promise<unknown>
}

/** KTX 2 image or array of a file. A plain image becomes an array of one slice. */
interface Ktx2Texture {
  array: ArrayTexture
  header: Ktx2Header
}

/** Throws if an image must not be decoded. */
type ShapeCheck = (shape: TextureShape) => void

/** Returns a reader of the KTX 2 images and arrays in a file that `GLTFLoader` loads. */
export function arraysOf(parser: GLTFParser): FileArrays {
  return {
    async load(index, use, check) {
      const loaded = await (use === 'areas' ? loadAreaArray : loadMapArray)(parser, index, check)
      // glTF defines the colour space by a texture's use, not by its file.
      loaded.array.colorSpace = use === 'colours' ? SRGBColorSpace : NoColorSpace
      return loaded
    },
    join: joinArrays,
  }
}

/**
 * Loads areas from a KTX 2 image or array, in the best format that the GPU supports.
 *
 * @throws FurrowError if the loader has no KTX2Loader, or KHR_texture_basisu does not allow the image.
 */
async function loadAreaArray(parser: GLTFParser, index: number, check: ShapeCheck): Promise<Ktx2Texture> {
  const file = await readFile(parser, index, check)
  const array = await transcode(file, ktx2LoaderOf(parser))
  // Areas are smooth, and mipmaps would bleed across UV islands.
  array.minFilter = LinearFilter
  return { array, header: file.header }
}

/**
 * Loads layer maps from a KTX 2 image or array. Uses BC1 instead of BC7 if supported, which halves the memory. Creases stay visible: see
 * "Sizes" in docs/pack.md.
 *
 * @throws FurrowError as `loadAreaArray`, or if three.js's KTX2Loader lacks a required internal.
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

/** Disables all formats except BC1 to BC3. */
const BC1_TO_BC3 = { astcSupported: false, bptcSupported: false, etc1Supported: false, etc2Supported: false }

/**
 * Creates a second loader that transcodes to other formats. It shares the transcoder binary: fetching that twice triggers a three.js
 * warning.
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

/** A KTX 2 file with its parsed header. */
interface Ktx2File {
  bytes: Uint8Array<ArrayBuffer>
  header: Ktx2Header
  /** Names the texture in errors. */
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
    throw fileError(error, who, 'KTX 2 image cannot be decoded')
  } finally {
    URL.revokeObjectURL(url)
  }
}

/** Converts to an array: `KTX2Loader` returns an array of one slice as a plain texture. */
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

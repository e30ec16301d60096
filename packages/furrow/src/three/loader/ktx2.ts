import { ClampToEdgeWrapping, CompressedArrayTexture, type CompressedTexture, LinearFilter } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { FurrowError } from '../../core/error.ts'
import { type Ktx2Header, readKtx2Header } from '../../core/ktx2-header.ts'
import { texturesOfFace } from '../../core/map-rules.ts'
import { WRINKLE_MAPS } from '../../core/wrinkle-maps.ts'
import type { ArrayTexture } from '../material/array-texture.ts'
import { requireInternal } from '../three-version.ts'

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

/**
 * Loads the areas of a file, a KTX 2 image or array, in the best format that the GPU supports.
 *
 * @throws FurrowError when the loader has no KTX2Loader, or the texture is not compressed.
 */
export async function loadAreaArray(parser: GLTFParser, index: number): Promise<ArrayTexture> {
  const array = await loadArray(parser, index, ktx2LoaderOf(parser))
  // Areas are smooth already, and mipmaps would bleed across UV islands.
  array.minFilter = LinearFilter
  return array
}

/**
 * Loads maps of a file's layers, a KTX 2 image or array, in half the memory where the GPU can: BC1 instead of BC7. Creases stay visible,
 * see "Sizes" in docs/pack.md.
 *
 * @throws FurrowError as `loadAreaArray` does, or when three.js's KTX2Loader lacks an internal that this needs.
 */
export async function loadMapArray(parser: GLTFParser, index: number): Promise<ArrayTexture> {
  const usual = ktx2LoaderOf(parser) as Transcoder
  const { workerConfig } = usual
  if (!workerConfig?.dxtSupported) return loadArray(parser, index, usual)
  const small = await withFormats(usual, { ...workerConfig, ...BC1_TO_BC3 })
  try {
    return await loadArray(parser, index, small)
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
  await requireInternal(loader.init, WRINKLE_MAPS, 'KTX2Loader.init').call(loader)
  const binary = requireInternal(loader.transcoderBinary, WRINKLE_MAPS, 'KTX2Loader.transcoderBinary')
  const source = requireInternal(loader.workerSourceURL, WRINKLE_MAPS, 'KTX2Loader.workerSourceURL')
  const other = new (loader.constructor as new () => Transcoder)()
  const { workerPool } = other
  const setWorkerCreator = requireInternal(
    workerPool?.setWorkerCreator,
    WRINKLE_MAPS,
    'KTX2Loader.workerPool.setWorkerCreator',
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

async function loadArray(parser: GLTFParser, index: number, loader: KTX2Loader): Promise<ArrayTexture> {
  const { extensions } = parser.json.textures[index]
  const source: unknown = extensions?.KHR_texture_basisu?.source
  if (typeof source !== 'number' || !parser.json.images?.[source]) {
    throw new FurrowError({
      who: `${WRINKLE_MAPS} texture ${index}`,
      what: 'a slice of an image that is not KTX 2',
      limit: 'a texture with KHR_texture_basisu',
      remedy: 'pack the file again',
    })
  }
  const header = await headerOf(parser, source, index)
  const loaded = (await parser.loadTextureImage(index, source, loader)) as CompressedTexture | null
  const texture = loaded && asArray(loaded)
  if (!texture) {
    throw new FurrowError({
      code: 'unreadable',
      who: `${WRINKLE_MAPS} texture ${index}`,
      what: 'not a compressed image or array',
      value: loaded ? `${loaded.image.width} x ${loaded.image.height}` : 'nothing readable',
      limit: 'KTX 2 in UASTC or ETC1S',
      remedy: 'pack the file again',
    })
  }
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping
  texture.magFilter = LinearFilter
  if (header) texture.userData.ktx2 = header
  return texture
}

/**
 * Checks the header before anything is decoded. Undefined for an image in a file of its own, which only the loader reads.
 *
 * @throws FurrowError when the image is not one that KHR_texture_basisu allows, or an array that the plain face uses as an image.
 */
async function headerOf(parser: GLTFParser, source: number, index: number): Promise<Ktx2Header | undefined> {
  const { bufferView } = parser.json.images?.[source] ?? {}
  if (bufferView === undefined) return undefined
  const who = `${WRINKLE_MAPS} texture ${index}`
  const header = readKtx2Header(new Uint8Array(await parser.getDependency('bufferView', bufferView)), who)
  const { materials, extensions } = parser.json
  if (header.slices === 0 || !texturesOfFace([materials, extensions]).has(index)) return header
  throw new FurrowError({
    who,
    what: 'an array, and a texture info without a slice refers to it',
    value: `${header.slices} slices`,
    remedy: 'give the plain face an image of its own',
  })
}

/** `KTX2Loader` returns an array of one slice as a plain texture. */
function asArray(texture: CompressedTexture): CompressedArrayTexture | null {
  if ('isCompressedArrayTexture' in texture) return texture as CompressedArrayTexture
  if (!texture.isCompressedTexture) return null
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
    what: 'the maps are KTX 2, which the loader cannot read',
    limit: 'a GLTFLoader with a KTX2Loader',
    remedy: 'call loader.setKTX2Loader(new KTX2Loader().setTranscoderPath(...).detectSupport(renderer))',
  })
}

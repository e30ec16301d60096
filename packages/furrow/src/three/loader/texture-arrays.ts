import {
  ClampToEdgeWrapping,
  CompressedArrayTexture,
  type CompressedTexture,
  type DataArrayTexture,
  LinearFilter,
} from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/wrinkle-maps.ts'
import { isSlice } from '../../core/wrinkle-set.ts'

export type ArrayTexture = CompressedArrayTexture | DataArrayTexture

/**
 * The array in which all of some maps lie.
 *
 * @param what the maps as an error shall name them.
 * @throws FurrowError where one of them is an image, or lies in another array.
 */
export function arrayOf(maps: readonly object[], who: string, what: string): ArrayTexture {
  const [first] = maps.filter(isSlice)
  if (maps.every((map) => isSlice(map) && map.array === first.array)) return first.array as ArrayTexture
  throw new FurrowError({
    who,
    what: `${what} that lie in different arrays`,
    limit: 'all images, or all slices of one array',
    remedy: 'pack them in one way',
  })
}

/** Whether a texture comes as KTX 2: it is nothing else, or the loader prefers that to the image beside it. */
export function isCompressed(parser: GLTFParser, index: number): boolean {
  const { source, extensions } = parser.json.textures[index]
  if (!extensions?.KHR_texture_basisu) return false
  return source === undefined || Boolean((parser.options as LoaderOptions).ktx2Loader)
}

interface LoaderOptions {
  ktx2Loader?: KTX2Loader | null
}

/** What three.js's types leave out of a KTX2Loader. */
type Transcoder = KTX2Loader & {
  /** What it found out about the GPU. */
  workerConfig: NonNullable<KTX2Loader['workerConfig']> | null
  transcoderPending: Promise<unknown> | null
  transcoderBinary: ArrayBuffer
  workerSourceURL: string
  workerPool: { setWorkerCreator(create: () => Worker): void; dispose(): void }
  init(): Promise<unknown>
}

/**
 * Loads the areas of a file, a KTX 2 image or array, in the best format that the GPU has.
 *
 * @throws FurrowError when the page gave the loader no KTX2Loader, or the texture is not compressed.
 */
export async function loadAreaArray(parser: GLTFParser, index: number): Promise<ArrayTexture> {
  const array = await loadArray(parser, index, ktx2LoaderOf(parser))
  // Areas are soft already, and mipmaps would bleed across UV islands.
  array.minFilter = LinearFilter
  return array
}

/**
 * Loads maps of a file's layers, a KTX 2 image or array, in half the memory where the GPU can: BC1 in place of BC7. Creases survive it,
 * see "Sizes" in docs/pack.md.
 *
 * @throws FurrowError as `loadAreaArray` does.
 */
export async function loadMapArray(parser: GLTFParser, index: number): Promise<ArrayTexture> {
  const usual = ktx2LoaderOf(parser) as Transcoder
  const { workerConfig } = usual
  if (!workerConfig?.dxtSupported) return loadArray(parser, index, usual)
  const small = await withFormats(usual, { ...workerConfig, ...NO_OTHERS })
  try {
    return await loadArray(parser, index, small)
  } finally {
    small.workerPool.dispose()
  }
}

/** All formats but BC1 to BC3. */
const NO_OTHERS = { astcSupported: false, bptcSupported: false, etc1Supported: false, etc2Supported: false }

/** A second loader that transcodes to other formats; a whole one would fetch the transcoder again, and three.js warns of it. */
async function withFormats(
  loader: Transcoder,
  workerConfig: Transcoder['workerConfig'],
): Promise<Transcoder> {
  await loader.init()
  const { transcoderBinary, workerSourceURL } = loader
  const other = new (loader.constructor as new () => Transcoder)()
  other.transcoderPending = Promise.resolve()
  other.workerConfig = workerConfig
  other.workerPool.setWorkerCreator(() => {
    const worker = new Worker(workerSourceURL)
    worker.postMessage({ type: 'init', config: workerConfig, transcoderBinary })
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
      what: 'a slice of what is no KTX 2 image',
      limit: 'a texture with KHR_texture_basisu',
      remedy: 'pack the file again',
    })
  }
  const loaded = (await parser.loadTextureImage(index, source, loader)) as CompressedTexture | null
  const texture = loaded && asArray(loaded)
  if (!texture) {
    throw new FurrowError({
      code: 'unreadable',
      who: `${WRINKLE_MAPS} texture ${index}`,
      what: 'no compressed image or array',
      value: loaded ? `${loaded.image.width} x ${loaded.image.height}` : 'nothing that can be read',
      limit: 'KTX 2 in UASTC or ETC1S',
      remedy: 'pack the file again',
    })
  }
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping
  texture.magFilter = LinearFilter
  return texture
}

/** `KTX2Loader` makes a plain texture of an array of one slice. */
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
    what: 'the maps are KTX 2, and the loader cannot read that',
    limit: 'a GLTFLoader with a KTX2Loader',
    remedy: 'call loader.setKTX2Loader(new KTX2Loader().setTranscoderPath(...).detectSupport(renderer))',
  })
}

import {
  ClampToEdgeWrapping,
  type CompressedArrayTexture,
  type CompressedTexture,
  type DataArrayTexture,
  LinearFilter,
} from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { FurrowError } from '../core/error.ts'
import { WRINKLE_MAPS } from '../core/wrinkle-maps.ts'

export type ArrayTexture = CompressedArrayTexture | DataArrayTexture

/** What a KTX2Loader found out about the GPU; three.js's types leave it out. */
type Transcoding = { workerConfig: Record<string, boolean> | null; transcoderPath: string }

/**
 * Loads the areas of a file, a KTX 2 array, in the best format that the GPU has.
 *
 * @throws FurrowError when the page gave the loader no KTX2Loader, or the texture is no array.
 */
export async function loadAreaArray(parser: GLTFParser, index: number): Promise<ArrayTexture> {
  const array = await loadArray(parser, index, ktx2LoaderOf(parser))
  // Areas are soft already, and mipmaps would bleed across UV islands.
  array.minFilter = LinearFilter
  return array
}

/**
 * Loads maps of a file's layers, a KTX 2 array, in half the memory where the GPU can: BC1 in place of BC7. Creases survive it,
 * see "Sizes" in docs/FURROW_wrinkle_maps.md.
 *
 * @throws FurrowError as `loadAreaArray` does.
 */
export async function loadMapArray(parser: GLTFParser, index: number): Promise<ArrayTexture> {
  const usual = ktx2LoaderOf(parser)
  const { workerConfig, transcoderPath } = usual as unknown as Transcoding
  if (!workerConfig?.dxtSupported) return loadArray(parser, index, usual)
  const small = new (usual.constructor as new () => KTX2Loader)()
  Object.assign(small, {
    transcoderPath,
    workerConfig: { ...workerConfig, astcSupported: false, bptcSupported: false },
  })
  try {
    return await loadArray(parser, index, small)
  } finally {
    small.dispose()
  }
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
  const texture = (await parser.loadTextureImage(index, source, loader)) as CompressedTexture | null
  if (!texture || !isArray(texture)) {
    throw new FurrowError({
      who: `${WRINKLE_MAPS} texture ${index}`,
      what: 'a slice of what is no array',
      value: texture ? `${texture.image.width} x ${texture.image.height}` : 'nothing that can be read',
      limit: 'a KTX 2 file with layers',
      remedy: 'pack the file again',
    })
  }
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping
  texture.magFilter = LinearFilter
  return texture
}

function isArray(texture: object): texture is ArrayTexture {
  return 'isCompressedArrayTexture' in texture || 'isDataArrayTexture' in texture
}

function ktx2LoaderOf(parser: GLTFParser): KTX2Loader {
  const { ktx2Loader } = parser.options as { ktx2Loader?: KTX2Loader | null }
  if (ktx2Loader) return ktx2Loader
  throw new FurrowError({
    who: WRINKLE_MAPS,
    what: 'the maps are KTX 2 arrays, and the loader cannot read those',
    limit: 'a GLTFLoader with a KTX2Loader',
    remedy: 'call loader.setKTX2Loader(new KTX2Loader().setTranscoderPath(...).detectSupport(renderer))',
  })
}

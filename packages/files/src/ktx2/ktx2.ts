import { isFileName } from 'furrow/internal'
import {
  KHR_DF_CHANNEL_RGBSDA_ALPHA,
  KHR_DF_KHR_DESCRIPTORTYPE_BASICFORMAT,
  KHR_DF_MODEL_RGBSDA,
  KHR_DF_PRIMARIES_BT709,
  KHR_DF_SAMPLE_DATATYPE_LINEAR,
  KHR_DF_TRANSFER_LINEAR,
  KHR_DF_TRANSFER_SRGB,
  KHR_DF_VENDORID_KHRONOS,
  KHR_DF_VERSION,
  KHR_SUPERCOMPRESSION_NONE,
  KHR_SUPERCOMPRESSION_ZSTD,
  type KTX2Container,
  read,
  VK_FORMAT_R8_SRGB,
  VK_FORMAT_R8_UNORM,
  VK_FORMAT_R8G8B8A8_SRGB,
  VK_FORMAT_R8G8B8A8_UNORM,
  VK_FORMAT_UNDEFINED,
  write,
} from 'ktx-parse'
import { decodeBasis, encodeBasis } from './basis.ts'
import { fixBasisTables } from './basis-tables.ts'
import type { Compression, NamedArray } from './image-array.ts'
import { readHeader } from './ktx2-header.ts'
import { zstd } from './zstd.ts'

/** KTX 2 metadata key. Its value is a JSON array of layer names. Khronos reserves keys that begin with KTX. */
export const NAMES_KEY = 'furrowLayers'

/**
 * Writes a texture array as a KTX 2 file (Khronos, KTX File Format Specification 2.0). `uastc` and `etc1s` write a
 * Basis Universal format. `none` and `zstd` write R8 or RGBA8.
 *
 * @param mipmaps whether to store mipmaps. Only for `uastc` and `etc1s`: the GPU generates mipmaps for other formats.
 */
export async function writeArray(
  array: NamedArray,
  compression: Compression,
  mipmaps = false,
): Promise<Uint8Array> {
  const container =
    compression === 'uastc' || compression === 'etc1s'
      ? readBasis(await encodeBasis(array, compression, mipmaps))
      : await plainContainer(array, compression)
  container.layerCount = array.layers.length
  container.keyValue = {
    ...container.keyValue,
    KTXorientation: 'rd',
    KTXwriter: 'furrow array',
    [NAMES_KEY]: JSON.stringify(array.names),
  }
  return write(container, { keepWriter: true })
}

/** Texture array decoded from a KTX 2 file, without layer names. */
export interface DecodedArray extends Omit<NamedArray, 'names'> {
  compression: Compression
}

/**
 * Reads the largest level and the layer names of a 2D array or 2D texture in R8, RGBA8 or a Basis Universal format. If
 * the file has no names, the layers are named `layer-0`, `layer-1` and so on.
 *
 * @throws Error with a short reason if the file is damaged or has another format.
 */
export async function readArray(bytes: Uint8Array): Promise<DecodedArray & NamedArray> {
  const array = await decodeArray(bytes)
  return { ...array, names: layerNames(readContainer(bytes), array.layers.length) }
}

/** Reads a KTX 2 file like `readArray`, but without layer names. */
export async function decodeArray(bytes: Uint8Array): Promise<DecodedArray> {
  const { format, width, height, slices } = readHeader(bytes)
  const count = Math.max(slices, 1)
  const container = readContainer(bytes)
  const srgb = container.dataFormatDescriptor[0].transferFunction === KHR_DF_TRANSFER_SRGB
  const channels = CHANNELS.get(format)
  if (format === VK_FORMAT_UNDEFINED) {
    const { layers, compression } = await decodeBasis(bytes, count)
    return { width, height, channels: 4, srgb, layers, compression }
  }
  if (channels === undefined) throw new Error(`its format is ${format}, not R8 or RGBA8`)
  const isCompressed = container.supercompressionScheme === KHR_SUPERCOMPRESSION_ZSTD
  if (!isCompressed && container.supercompressionScheme !== KHR_SUPERCOMPRESSION_NONE) {
    throw new Error(`its supercompression is ${container.supercompressionScheme}, not Zstandard`)
  }
  const level = container.levels[0]
  const size = width * height * channels
  const { decompress } = await zstd()
  const data = isCompressed ? decompress(level.levelData, size * count) : level.levelData
  if (data.length !== size * count) {
    throw new Error(`it has ${data.length} bytes instead of ${size * count}`)
  }
  const layers = Array.from({ length: count }, (_, i) => data.slice(i * size, (i + 1) * size))
  return { width, height, channels, srgb, layers, compression: isCompressed ? 'zstd' : 'none' }
}

/** Parses a KTX 2 file. Replaces the errors of ktx-parse, which mention only an invalid offset. */
function readContainer(bytes: Uint8Array): KTX2Container {
  try {
    return read(bytes)
  } catch {
    throw new Error('it is damaged')
  }
}

function readBasis(bytes: Uint8Array): KTX2Container {
  const container = read(bytes)
  fixBasisTables(container, bytes)
  return container
}

const CHANNELS = new Map<number, 1 | 4>([
  [VK_FORMAT_R8_UNORM, 1],
  [VK_FORMAT_R8_SRGB, 1],
  [VK_FORMAT_R8G8B8A8_UNORM, 4],
  [VK_FORMAT_R8G8B8A8_SRGB, 4],
])

async function plainContainer(array: NamedArray, compression: 'none' | 'zstd'): Promise<KTX2Container> {
  const { width, height, channels, srgb, layers } = array
  const size = width * height * channels
  const data = new Uint8Array(size * layers.length)
  for (const [i, layer] of layers.entries()) data.set(layer, i * size)
  const { compress } = await zstd()
  const gray = channels === 1
  return {
    vkFormat: gray
      ? srgb
        ? VK_FORMAT_R8_SRGB
        : VK_FORMAT_R8_UNORM
      : srgb
        ? VK_FORMAT_R8G8B8A8_SRGB
        : VK_FORMAT_R8G8B8A8_UNORM,
    typeSize: 1,
    pixelWidth: width,
    pixelHeight: height,
    pixelDepth: 0,
    layerCount: layers.length,
    faceCount: 1,
    levelCount: 1,
    supercompressionScheme: compression === 'zstd' ? KHR_SUPERCOMPRESSION_ZSTD : KHR_SUPERCOMPRESSION_NONE,
    levels: [
      {
        levelData: compression === 'zstd' ? compress(data) : data,
        uncompressedByteLength: data.length,
      },
    ],
    dataFormatDescriptor: [
      {
        vendorId: KHR_DF_VENDORID_KHRONOS,
        descriptorType: KHR_DF_KHR_DESCRIPTORTYPE_BASICFORMAT,
        versionNumber: KHR_DF_VERSION,
        colorModel: KHR_DF_MODEL_RGBSDA,
        colorPrimaries: KHR_DF_PRIMARIES_BT709,
        transferFunction: srgb ? KHR_DF_TRANSFER_SRGB : KHR_DF_TRANSFER_LINEAR,
        flags: 0,
        texelBlockDimension: [0, 0, 0, 0],
        bytesPlane: [channels, 0, 0, 0, 0, 0, 0, 0],
        samples: Array.from({ length: channels }, (_, k) => ({
          bitOffset: 8 * k,
          bitLength: 7,
          // Alpha is linear even in sRGB formats (Khronos Data Format Specification 1.3, 5.14).
          channelType: k < 3 ? k : KHR_DF_CHANNEL_RGBSDA_ALPHA | (srgb ? KHR_DF_SAMPLE_DATATYPE_LINEAR : 0),
          samplePosition: [0, 0, 0, 0],
          sampleLower: 0,
          sampleUpper: 255,
        })),
      },
    ],
    keyValue: {},
    globalData: null,
  }
}

/** Reads layer names from the metadata. Throws if the names are not unique or not valid as file names. */
function layerNames({ keyValue }: KTX2Container, count: number): string[] {
  const text = keyValue[NAMES_KEY]
  if (text === undefined) return Array.from({ length: count }, (_, i) => `layer-${i}`)
  let names: unknown
  try {
    // Strings in KTX 2 metadata end with NUL.
    names = JSON.parse((typeof text === 'string' ? text : new TextDecoder().decode(text)).replace(/\0$/, ''))
  } catch {
    // The check below throws, because `names` stays undefined.
  }
  if (
    !Array.isArray(names) ||
    names.length !== count ||
    !names.every((name) => typeof name === 'string' && isFileName(name)) ||
    new Set(names).size !== count
  ) {
    throw new Error(`its metadata ${NAMES_KEY} does not have ${count} different names`)
  }
  return names
}

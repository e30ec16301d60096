import { FurrowError } from 'furrow'
import type { NamedArray } from './image-array.ts'

/**
 * Methods of the Basis Universal encoder's JavaScript bindings that this file calls (basis_wrappers.cpp, version 2.5).
 */
interface Encoder {
  setUASTC(on: boolean): void
  setPackUASTCFlags(effort: number): void
  setKTX2UASTCSupercompression(on: boolean): void
  setQualityLevel(quality: number): void
  setETC1SCompressionLevel(effort: number): void
  setCreateKTX2File(on: boolean): void
  setTexType(type: number): void
  setPerceptual(on: boolean): void
  setKTX2AndBasisSRGBTransferFunc(on: boolean): void
  setMipGen(on: boolean): void
  setMipSRGB(on: boolean): void
  setMipWrapping(on: boolean): void
  setDebug(on: boolean): void
  setStatusOutput(on: boolean): void
  setSliceSourceImage(slice: number, rgba: Uint8Array, width: number, height: number, type: number): boolean
  encode(out: Uint8Array): number
  delete(): void
}

/** Methods of the transcoder's JavaScript bindings that this file calls. */
interface Transcoder {
  isValid(): boolean
  isUASTC(): boolean
  isETC1S(): boolean
  getLayers(): number
  getLevels(): number
  startTranscoding(): boolean
  getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number
  transcodeImage(
    out: Uint8Array,
    level: number,
    layer: number,
    face: number,
    format: number,
    flags: number,
    channel0: number,
    channel1: number,
  ): number
  close(): void
  delete(): void
}

interface BasisModule {
  BasisEncoder: new () => Encoder
  KTX2File: new (bytes: Uint8Array) => Transcoder
}

type BasisLoader = new () => { init(): Promise<BasisModule> }

const TEXTURE_2D_ARRAY = 1
const RAW_RGBA = 0
const TRANSCODE_TO_RGBA32 = 13

/** Maximum texels of all layers together. The encoder is 32-bit WebAssembly, so its memory is limited. */
const MAX_TEXELS = 12 * 1024 * 1024

/** Encoder effort, 0 to 4: higher is slower and has fewer artefacts. */
const UASTC_EFFORT = 2
/** Quality, 1 to 255: higher gives larger files with fewer artefacts. */
const ETC1S_QUALITY = 255
/** Encoder effort, 0 to 6: higher is slower and has fewer artefacts. */
const ETC1S_EFFORT = 2

let loading: Promise<BasisModule> | undefined

/** Loads the WebAssembly module once. */
function basis(): Promise<BasisModule> {
  loading ??= import('ktx2-encoder').then((library: unknown) => {
    // The package exports one class in Node and another in browsers.
    const { NodeBasisEncoder, BrowserBasisEncoder } = library as Record<string, BasisLoader | undefined>
    return new (NodeBasisEncoder ?? BrowserBasisEncoder)!().init()
  })
  return loading
}

/**
 * Encodes a texture array as a KTX 2 file in UASTC (with Zstandard) or ETC1S. Converts gray layers to RGBA.
 *
 * @throws FurrowError if the array is too large for the encoder, or a side is not a multiple of 4 texels.
 */
export async function encodeBasis(
  array: NamedArray,
  format: 'uastc' | 'etc1s',
  mipmaps: boolean,
): Promise<Uint8Array> {
  const { width, height, srgb, layers } = array
  checkBasisSize(array, 'furrow array', 'scale the images, make several arrays, or use --compress zstd')
  const encoder = new (await basis()).BasisEncoder()
  try {
    encoder.setDebug(false)
    encoder.setStatusOutput(false)
    encoder.setCreateKTX2File(true)
    encoder.setTexType(TEXTURE_2D_ARRAY)
    encoder.setUASTC(format === 'uastc')
    encoder.setPackUASTCFlags(UASTC_EFFORT)
    encoder.setKTX2UASTCSupercompression(true)
    encoder.setQualityLevel(ETC1S_QUALITY)
    encoder.setETC1SCompressionLevel(ETC1S_EFFORT)
    encoder.setPerceptual(srgb)
    encoder.setKTX2AndBasisSRGBTransferFunc(srgb)
    encoder.setMipGen(mipmaps)
    encoder.setMipSRGB(srgb)
    encoder.setMipWrapping(false)
    for (const [i, layer] of layers.entries()) {
      const rgba = array.channels === 4 ? layer : grayToRgba(layer)
      if (encoder.setSliceSourceImage(i, rgba, width, height, RAW_RGBA) === false) throw encoderError(array)
    }
    // Upper bound for 4 bytes per texel, mipmaps (4/3 of the texels) and 1 MB of tables.
    const out = new Uint8Array(Math.ceil((width * height * layers.length * 16) / 3) + 2 ** 20)
    const length = encoder.encode(out)
    if (length === 0) throw encoderError(array)
    return out.slice(0, length)
  } finally {
    encoder.delete()
  }
}

/**
 * Decodes all levels and layers to RGBA, to find damage. Returns only the largest level.
 *
 * @param count number of layers that the file must have.
 * @throws Error with a short reason if a level is damaged.
 */
export async function decodeBasis(
  bytes: Uint8Array,
  count: number,
): Promise<{ layers: Uint8Array[]; compression: 'uastc' | 'etc1s' }> {
  const file = new (await basis()).KTX2File(bytes)
  try {
    if (!file.isValid() || !(file.isUASTC() || file.isETC1S())) throw new Error('its format is unknown')
    if (Math.max(file.getLayers(), 1) !== count || !file.startTranscoding()) throw new Error('it is damaged')
    const decode = (level: number) =>
      Array.from({ length: count }, (_, layer) => {
        const out = new Uint8Array(file.getImageTranscodedSizeInBytes(level, layer, 0, TRANSCODE_TO_RGBA32))
        if (!file.transcodeImage(out, level, layer, 0, TRANSCODE_TO_RGBA32, 0, -1, -1))
          throw new Error('it is damaged')
        return out
      })
    const layers = decode(0)
    for (let level = 1; level < file.getLevels(); level++) decode(level)
    return { layers, compression: file.isUASTC() ? 'uastc' : 'etc1s' }
  } finally {
    file.close()
    file.delete()
  }
}

function grayToRgba(gray: Uint8Array): Uint8Array {
  const rgba = new Uint8Array(4 * gray.length).fill(255)
  for (let i = 0; i < gray.length; i++) rgba.fill(gray[i], 4 * i, 4 * i + 3)
  return rgba
}

/**
 * Checks the size of an array before encoding. WebGPU requires block-compressed textures to have sides that are
 * multiples of the block size, 4 texels.
 *
 * @param who module name for errors.
 * @param remedy for errors.
 * @throws FurrowError if the array has too many texels, or a side is not a multiple of 4.
 */
export function checkBasisSize({ width, height, layers }: NamedArray, who: string, remedy: string): void {
  if (width * height * layers.length > MAX_TEXELS) {
    throw new FurrowError({
      code: 'out-of-range',
      who,
      problem: 'too many texels for this compression',
      value: `${layers.length} x ${width} x ${height}`,
      limit: `${MAX_TEXELS} in total`,
      remedy,
    })
  }
  if (width % 4 === 0 && height % 4 === 0) return
  throw new FurrowError({
    who,
    problem: 'this compression does not support the size',
    value: `${width} x ${height}`,
    limit: 'multiples of 4 texels',
    remedy,
  })
}

function encoderError({ width, height, layers }: NamedArray): FurrowError {
  return new FurrowError({
    who: 'furrow array',
    problem: 'the Basis Universal encoder rejected the images',
    value: `${layers.length} x ${width} x ${height}`,
    remedy: 'use --compress zstd, or smaller images',
  })
}

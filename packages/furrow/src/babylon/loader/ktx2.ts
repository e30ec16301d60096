import { channelOf } from '../../core/channels.ts'
import { isSlice } from '../../core/check-areas.ts'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { readKtx2Header } from '../../core/maps/ktx2-header.ts'
import type { TextureShape } from '../../core/maps/rules.ts'
import type { ArraySlice, GrayImage, RgbaImage, WrinkleSet } from '../../core/types.ts'
import { fileError } from '../../runtime/file/file-error.ts'
import { type Transcoded, type TranscodeRequest, transcodeInWorker } from './transcode-worker.ts'

/** All slices of a decoded KTX 2 file. */
interface UnpackedArray {
  images: readonly RgbaImage[]
}

/**
 * Decodes a KTX 2 image or array to 8-bit RGBA images.
 *
 * @param bytes KTX 2 file; undefined if the texture has no KTX 2 image.
 * @param who name of the texture in errors.
 * @param check is called with the size before decoding, and throws if the image is too large.
 * @param transcoderPath folder of `basis_transcoder.js` and `basis_transcoder.wasm`.
 * @throws FurrowError if KHR_texture_basisu does not allow the image, or if the transcoder is missing or fails.
 */
export async function loadKtx2(
  bytes: Uint8Array<ArrayBuffer> | undefined,
  who: string,
  check: (shape: TextureShape) => void,
  transcoderPath: string | undefined,
): Promise<{ array: UnpackedArray; header: TextureShape }> {
  if (!bytes) {
    throw new FurrowError({
      who,
      problem: 'the map is a slice of an image that is not KTX 2',
      limit: 'a texture with KHR_texture_basisu',
      remedy: 'pack the file again',
    })
  }
  if (transcoderPath === undefined) {
    throw new FurrowError({
      code: 'unsupported',
      who: WRINKLE_MAPS,
      problem: 'the maps are KTX 2, and there is no transcoder',
      limit: 'registerWrinkleMaps with transcoderPath',
      remedy: 'set the folder of basis_transcoder.js, or pack the file without --ktx2; see docs/babylon.md',
    })
  }
  const header = readKtx2Header(bytes, who)
  check(header)
  try {
    const { width, height, slices } = await transcode({
      script: new URL('basis_transcoder.js', folderOf(transcoderPath)).href,
      binary: new URL('basis_transcoder.wasm', folderOf(transcoderPath)).href,
      bytes,
    })
    return { array: { images: slices.map((data) => ({ width, height, data })) }, header }
  } catch (error) {
    throw fileError(error, who, 'KTX 2 image cannot be decoded')
  }
}

/** Returns a copy of a wrinkle set with images instead of slices of the arrays that `loadKtx2` has decoded. */
export function withImages({ layers, areas }: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice> {
  return {
    layers: layers.map((layer) => {
      const { normal, baseColor, roughness, occlusion, blood, onset } = layer
      return {
        ...layer,
        normal: imageOf(normal),
        ...(baseColor && { baseColor: imageOf(baseColor) }),
        ...(roughness && { roughness: grayOf(roughness) }),
        ...(occlusion && { occlusion: grayOf(occlusion) }),
        ...(blood && { blood: grayOf(blood) }),
        ...(onset && { onset: grayOf(onset) }),
      }
    }),
    areas: areas.map((area) => ({ ...area, weights: grayOf(area.weights) })),
  }
}

function imageOf(map: RgbaImage | ArraySlice): RgbaImage {
  return isSlice(map) ? (map.array as UnpackedArray).images[map.slice] : map
}

function grayOf(map: GrayImage | ArraySlice): GrayImage {
  return isSlice(map) ? channelOf(imageOf(map), map.channel) : map
}

function folderOf(path: string): URL {
  return new URL(path.endsWith('/') ? path : `${path}/`, location.href)
}

/** Decodes a KTX 2 file in a new web worker, and terminates the worker. */
async function transcode(request: TranscodeRequest): Promise<Extract<Transcoded, { slices: unknown }>> {
  const url = URL.createObjectURL(new Blob([`(${transcodeInWorker})()`], { type: 'text/javascript' }))
  const worker = new Worker(url)
  try {
    const answer = await new Promise<Transcoded>((resolve, reject) => {
      worker.onmessage = ({ data }) => resolve(data)
      worker.onerror = ({ message }) => reject(new Error(message))
      worker.postMessage(request)
    })
    if ('error' in answer) throw new Error(answer.error)
    return answer
  } finally {
    worker.terminate()
    URL.revokeObjectURL(url)
  }
}

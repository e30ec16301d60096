import sharp, { type Metadata, type Sharp } from 'sharp'
import { checkImageSize, checkImageType, formatNames, GLTF_IMAGES, type ImageHeader } from './check-image.ts'
import { withImageErrors } from './image-errors.ts'

/** Formats that libvips must not read. `sharp.block` ignores formats that the build of libvips does not support. */
const BLOCKED = [
  'Analyze',
  'Csv',
  'Dcraw',
  'Fits',
  'Jp2k',
  'Jxl',
  'Magick',
  'Magick7',
  'Mat',
  'Matrix',
  'Nifti',
  'Nsgif',
  'OpenExr',
  'Openslide',
  'Pdf',
  'Ppm',
  'Rad',
  'Raw',
  'Svg',
  'Uhdr',
  'Vips',
]

// Second line of defence after `checkImageType`. `sharp.block` applies to all threads of the process. Do not block all
// formats and then unblock the allowed ones: in the meantime, reading an allowed format would fail in other threads.
sharp.block({ operation: BLOCKED.map((format) => `VipsForeignLoad${format}`) })

/** Image whose header has been checked. It is not decoded yet. */
export interface OpenedImage extends ImageHeader, Pick<Metadata, 'channels' | 'depth'> {
  /** Lazy image, to be decoded once. Ignores colour profiles. Decoding throws if the image is truncated. */
  image: Sharp
}

/**
 * Reads and checks the header of an image.
 *
 * @param name name of the image, for errors.
 * @param types allowed formats.
 * @throws FurrowError if the image has another format, is damaged, is larger than 8192 texels per side, or would take
 *   too much memory.
 */
export async function openImage(
  bytes: Uint8Array,
  name: string,
  who: string,
  types = GLTF_IMAGES,
): Promise<OpenedImage> {
  const type = checkImageType(bytes, name, who, types)
  const image = sharp(bytes, { failOn: 'truncated', ignoreIcc: true })
  const { width, height, channels, depth } = await withImageErrors(name, who, () => image.metadata(), {
    limit: formatNames(types),
  })
  const decodedBytes = width * height * channels * (DEPTH_BYTES[depth] ?? 8)
  checkImageSize({ width, height, decodedBytes }, name, who)
  return { image, type, width, height, channels, depth, decodedBytes }
}

/** Bytes per channel for each depth of libvips. Depths that are not listed have up to 8 bytes. */
const DEPTH_BYTES: Record<string, number | undefined> = {
  uchar: 1,
  char: 1,
  ushort: 2,
  short: 2,
  uint: 4,
  int: 4,
  float: 4,
}

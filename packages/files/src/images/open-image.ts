import sharp, { type Metadata, type Sharp } from 'sharp'
import { checkImageSize, checkImageType, formatNames, GLTF_IMAGES, type ImageHeader } from './check-image.ts'
import { withImageErrors } from './image-errors.ts'

/** The formats that libvips must not read, in any of its builds. */
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

// `checkImageType` knows the format; this keeps libvips from its other readers, whatever it takes a file for. It holds
// for all threads at once. To block every reader first and then allow some would fail images that another thread reads.
sharp.block({ operation: BLOCKED.map((format) => `VipsForeignLoad${format}`) })

/** An image that may be decoded: its header says that it is small enough. */
export interface OpenedImage extends ImageHeader, Pick<Metadata, 'channels' | 'depth'> {
  /** To be decoded once; colour profiles are ignored, and what is cut off is an error. */
  image: Sharp
}

/**
 * Reads the header of an image.
 *
 * @param name of the image, for errors.
 * @param types the formats that are allowed, known by their first bytes.
 * @throws FurrowError when it is in another format, damaged, longer than 8192 texels on a side, or would take too much
 *   memory.
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

/** Bytes per channel by the name that libvips has for it; up to 8 for others. */
const DEPTH_BYTES: Record<string, number | undefined> = {
  uchar: 1,
  char: 1,
  ushort: 2,
  short: 2,
  uint: 4,
  int: 4,
  float: 4,
}

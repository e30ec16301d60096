import { FurrowError, MAX_IMAGE_BYTES } from 'furrow'

/** How many times its size the images of a large file may take together. */
const DECODED_PER_BYTE = 16

/** Most bytes of all decoded images of a face together; `MAX_IMAGE_BYTES` is that of one. */
export function mostFaceBytes(fileBytes: number): number {
  return Math.max(MAX_IMAGE_BYTES, DECODED_PER_BYTE * fileBytes)
}

/**
 * Checks a size that a header gives, before anything is allocated for it.
 *
 * @param name of the image or file, for the error.
 * @throws FurrowError when it is too large.
 */
export function checkDecodedBytes(bytes: number, name: string, who: string, limit = MAX_IMAGE_BYTES): void {
  if (bytes <= limit) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    what: `${name} would decode to too many bytes`,
    value: megabytes(bytes),
    limit: megabytes(limit),
    remedy: 'scale it down',
  })
}

const megabytes = (bytes: number) => `${Math.ceil(bytes / 2 ** 20)} MiB`

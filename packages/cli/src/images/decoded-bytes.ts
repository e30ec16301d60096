import { FurrowError, MAX_IMAGE_BYTES } from 'furrow'

/** Most bytes of all decoded images of a face together; `MAX_IMAGE_BYTES` is that of one. */
export const MAX_FACE_BYTES = 2 ** 29

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

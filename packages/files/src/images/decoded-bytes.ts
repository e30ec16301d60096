import { FurrowError } from 'furrow'
import { MAX_IMAGE_BYTES } from 'furrow/internal'

/**
 * Checks the decoded size that a header declares, before memory is allocated.
 *
 * @param name name of the image or file, for errors.
 * @throws FurrowError if the size exceeds the limit.
 */
export function checkDecodedBytes(bytes: number, name: string, who: string): void {
  if (bytes <= MAX_IMAGE_BYTES) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: `${name} would decode to too many bytes`,
    value: megabytes(bytes),
    limit: megabytes(MAX_IMAGE_BYTES),
    remedy: 'scale it down',
  })
}

const megabytes = (bytes: number) => `${Math.ceil(bytes / 2 ** 20)} MiB`

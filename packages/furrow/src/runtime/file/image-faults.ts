import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'

/**
 * The error for a file that is not an image, or not a whole one.
 *
 * @param value what is wrong with it; how long it is by default.
 */
export function unreadable(bytes: Uint8Array, who: string, value = `${bytes.length} bytes`): FurrowError {
  if (bytes.length === 0) {
    return new FurrowError({
      code: 'unreadable',
      who,
      problem: 'empty file',
      value: '0 bytes',
      remedy: 'export the image again',
    })
  }
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: 'not a readable image',
    value,
    limit: 'a whole PNG, JPEG, WebP or AVIF file',
    remedy: 'export the image again; it may be cut off',
  })
}

/**
 * The error for an image that is not there.
 *
 * @param address of it.
 */
export function notFetched(address: string, who: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: 'an image that cannot be fetched',
    value: address,
    remedy: 'check that the server serves it at this address',
  })
}

/** The error for an image that is larger than `MAX_IMAGE_SIDE`. */
export function tooLarge({ width, height }: { width: number; height: number }, who: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who,
    problem: 'image too large',
    value: `${width} x ${height}`,
    limit: `${MAX_IMAGE_SIDE} texels on a side`,
    remedy: 'scale it down; areas need 128 texels, normal maps 1024 to 4096',
  })
}

/** The error for an image with transparent texels. */
export function transparent(alpha: number, who: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'image with transparent texels',
    value: `alpha ${alpha}`,
    limit: 'alpha 255 throughout',
    remedy: 'flatten it onto white (an area) or onto 128, 128, 255 (a normal map)',
  })
}

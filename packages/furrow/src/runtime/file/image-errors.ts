import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE } from '../../core/limits.ts'

/**
 * Creates the error for a file that is not an intact image.
 *
 * @param value description of the damage. Default: length of the file.
 */
export function unreadable(bytes: Uint8Array, who: string, value = `${bytes.length} bytes`): FurrowError {
  if (bytes.length === 0) {
    return new FurrowError({
      code: 'unreadable',
      who,
      problem: 'empty image file',
      value: '0 bytes',
      remedy: 'export the image again',
    })
  }
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: 'not a readable image',
    value,
    limit: 'an intact PNG, JPEG, WebP or AVIF file',
    remedy: 'export the image again; the file may be truncated',
  })
}

export function notFetched(address: string, who: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: 'image cannot be fetched',
    value: address,
    remedy: 'check that the server serves it at this address',
  })
}

export function tooLarge({ width, height }: { width: number; height: number }, who: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who,
    problem: 'image too large',
    value: `${width} x ${height}`,
    limit: `at most ${MAX_IMAGE_SIDE} texels per side`,
    remedy: 'scale the image down; areas need 128 texels, normal maps 1024 to 4096',
  })
}

export function transparent(alpha: number, who: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'image with transparent texels',
    value: `alpha ${alpha}`,
    limit: 'alpha 255 in all texels',
    remedy: 'flatten the image onto white (area) or onto 128, 128, 255 (normal map)',
  })
}

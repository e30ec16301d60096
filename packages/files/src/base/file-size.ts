import { FurrowError } from 'furrow'

/** Most bytes of a file that is read, and of a face with all files that it refers to. */
export const MAX_FILE_BYTES = 2 ** 29

/** The same of JSON, which can take 25 times its size in memory. */
export const MAX_JSON_BYTES = 2 ** 26

/**
 * Checks the size of a file before it is read.
 *
 * @param name of the file, as the user knows it.
 * @throws FurrowError when it is too large.
 */
export function checkFileBytes(bytes: number, name: string, who: string, most = MAX_FILE_BYTES): void {
  if (bytes <= most) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: `${name} is too large`,
    value: `${Math.ceil(bytes / 2 ** 20)} MiB`,
    limit: `${most / 2 ** 20} MiB${most === MAX_JSON_BYTES ? ' of JSON' : ''}`,
    remedy: 'make it smaller',
  })
}

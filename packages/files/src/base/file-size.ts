import { FurrowError } from 'furrow'

/** Maximum size of an input file, and of a glTF file together with its referenced files. */
export const MAX_FILE_BYTES = 2 ** 29

/** Maximum size of JSON. Parsed JSON can take 25 times as much memory as its text. */
export const MAX_JSON_BYTES = 2 ** 26

/**
 * Checks the size of a file before it is read.
 *
 * @param name name of the file, for errors.
 * @throws FurrowError if the file is too large.
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

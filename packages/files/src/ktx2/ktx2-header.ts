import { type Ktx2Image, readKtx2Image } from 'furrow/internal'
import { kindOf } from '../base/file-kind.ts'

/**
 * Reads and checks the header of a KTX 2 file. Does not decode the image.
 *
 * @throws Error with a short reason.
 */
export function readHeader(bytes: Uint8Array): Ktx2Image {
  const kind = kindOf(bytes)
  if (kind !== undefined && kind !== 'a KTX 2 file') throw new Error(`it is ${kind}, not KTX 2`)
  return readKtx2Image(bytes, (problem, value) => {
    throw new Error(value === undefined ? problem : `${problem}: ${value}`)
  })
}

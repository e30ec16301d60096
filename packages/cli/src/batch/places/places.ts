import { files } from './files.ts'
import type { Place } from './place.ts'
import { s3 } from './s3.ts'
import { web } from './web.ts'

/** Whether an address is on the network rather than a path. */
export function isRemote(address: string): boolean {
  return /^(s3|https?):\/\//i.test(address)
}

/** The place of an address. */
export function placeOf(address: string): Place {
  if (/^s3:\/\//i.test(address)) return s3
  return isRemote(address) ? web : files
}

import type { FileStore } from './file-store.ts'
import { files } from './local-files.ts'
import { s3 } from './s3.ts'
import { web } from './web.ts'

/** Returns whether an address is a URL and not a path. */
export function isRemote(address: string): boolean {
  return /^(s3|https?):\/\//i.test(address)
}

export function storeOf(address: string): FileStore {
  if (/^s3:\/\//i.test(address)) return s3
  return isRemote(address) ? web : files
}

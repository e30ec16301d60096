import type { Skin } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'

/** Returns the skin of a face in a file, as `furrow auto` finds it. */
export async function skinAt(path: string): Promise<Skin> {
  return findSkin(await readDocument(path, 'skinAt'), path, 'skinAt').skin
}

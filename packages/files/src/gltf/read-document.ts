import type { Document } from '@gltf-transform/core'
import type { ReadOptions } from '../disk/external-files.ts'
import { documentOf } from './document.ts'
import { readGlbFile } from './read-glb-file.ts'

/** Reads a glTF file and decodes it. Throws like `readGlbFile` and `documentOf`. */
export async function readDocument(path: string, who: string, options?: ReadOptions): Promise<Document> {
  return documentOf(await readGlbFile(path, who, options), path, who)
}

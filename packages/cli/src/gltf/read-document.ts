import type { Document } from '@gltf-transform/core'
import { documentOf } from './document.ts'
import type { ReadOptions } from './external-files.ts'
import { readGlbFile } from './read-glb-file.ts'

/** Reads a file as `readGlbFile` does, and decodes it; see `documentOf`. */
export async function readDocument(path: string, who: string, options?: ReadOptions): Promise<Document> {
  return documentOf(await readGlbFile(path, who, options), path, who)
}

import type { DocumentToPack } from '../../../studio/src/document/packed-layers.ts'
import { folderFiles } from '../../../studio/src/keep/folder-files.ts'

/** Returns the files that a document is stored in, by path, without a face. */
export function projectFiles(source: DocumentToPack): Map<string, Uint8Array> {
  return new Map(folderFiles(source, []).map(({ path, content }) => [path, content as Uint8Array]))
}

/** Returns files in the form in which the studio opens them. */
export const opened = (files: Iterable<[string, Uint8Array]>) =>
  Array.from(files, ([path, bytes]) => ({ path, file: new Blob([bytes as BlobPart]) }))

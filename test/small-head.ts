import { Logger, NodeIO } from '@gltf-transform/core'
import { readDocument } from 'furrow-files/node'
import { decimate } from './heads.ts'

/** Returns a file with a shipped face that is reduced to about 2,000 vertices, as characters in games have. */
export async function smallHead(face: string): Promise<Uint8Array> {
  const document = await readDocument(face, 'test')
  await decimate(document, 0.16)
  // The document's own extensions concern materials, and are not written.
  const silent = new Logger(Logger.Verbosity.SILENT)
  return new NodeIO().setLogger(silent).writeBinary(document.setLogger(silent))
}

import { resampleGray } from 'furrow'
import { withoutAlpha } from '../../../packages/cli/src/images/pixels.ts'
import { encodePortablePng } from '../../../packages/cli/src/images/png.ts'
import type { ImageFile, StudioDocument } from '../document/document.ts'
import type { DrawnMaps } from '../draw/messages.ts'
import type { AvatarFile } from '../keep/database.ts'
import { type DrawnMaps as DrawnFiles, folderFiles } from '../keep/folder-files.ts'
import { type ExportedFace, type ExportOptions, exportFace, type OnProgress } from './export-face.ts'
import type { FaceFiles, Files } from './files.ts'

/** A document with the maps that were drawn from its strokes. */
export interface DocumentToExport {
  document: StudioDocument
  /** By the names of layers with strokes. */
  drawn: ReadonlyMap<string, DrawnMaps>
}

/**
 * Adds the wrinkles of a document to a face, by way of the folder that `furrow pack` reads; see `exportFace`.
 *
 * @throws FurrowError when the face or the wrinkles cannot be used.
 */
export async function exportDocument(
  face: FaceFiles,
  source: DocumentToExport,
  options: ExportOptions = {},
  onProgress: OnProgress = () => {},
): Promise<ExportedFace> {
  return exportFace(face, await projectFiles(source), options, onProgress)
}

/**
 * The folder of a document as `furrow pack` reads it.
 *
 * @param face the avatar's files, the first of which is the face; none to leave it out.
 */
export async function projectFiles(
  { document, drawn }: DocumentToExport,
  face: readonly AvatarFile[] = [],
): Promise<Files> {
  const maps = new Map([...drawn].map(([layer, each]) => [layer, encodeMaps(each)]))
  const files = await folderFiles(document, face, maps, async (pixels) => encodePortablePng(pixels))
  const contents = files.map(async ({ path, content }): Promise<[string, Uint8Array]> => {
    return [path, content instanceof Blob ? new Uint8Array(await content.arrayBuffer()) : content]
  })
  return new Map(await Promise.all(contents))
}

/** Occlusion has half the side of the normals, as automatic wrinkles write it: only these show how steep a crease is. */
function encodeMaps({ normal, occlusion }: DrawnMaps): DrawnFiles {
  const half = resampleGray(occlusion, occlusion.width / 2)
  return {
    maps: {
      normal: png(encodePortablePng(withoutAlpha({ ...normal, channels: 4 }))),
      occlusion: png(encodePortablePng({ ...half, channels: 1 })),
    },
  }
}

function png(bytes: Uint8Array): ImageFile {
  return { mimeType: 'image/png', bytes }
}

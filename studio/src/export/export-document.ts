import { type HeightMap, halfSide, heightLevels } from 'furrow/author'
import { encodePortablePng, withoutAlpha } from 'furrow-files'
import type { ImageFile, StudioDocument } from '../document/document.ts'
import type { DrawnMaps } from '../document/drawn-maps.ts'
import type { FaceFiles, Files } from '../files/face-files.ts'
import type { AvatarFile } from '../files/folder-files.ts'
import { type DrawnMaps as DrawnFiles, folderFiles } from '../keep/folder-files.ts'
import { type ExportedFace, type ExportOptions, exportFace, type OnProgress } from './export-face.ts'

/** A document with the maps that were drawn from its strokes. */
export interface DocumentToExport {
  document: StudioDocument
  /** By the names of layers with strokes. */
  drawn: ReadonlyMap<string, StrokeMaps>
}

/** The maps of a layer that are drawn from strokes, with their heights. */
export interface StrokeMaps extends DrawnMaps {
  readonly relief: HeightMap
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
  const painted = new Set(document.layers.flatMap(({ name, maps }) => (maps.height ? name : [])))
  const maps = new Map([...drawn].map(([layer, each]) => [layer, encodeMaps(each, painted.has(layer))]))
  const files = await folderFiles(document, face, maps, async (pixels) => encodePortablePng(pixels))
  const contents = files.map(async ({ path, content }): Promise<[string, Uint8Array]> => {
    return [path, content instanceof Blob ? new Uint8Array(await content.arrayBuffer()) : content]
  })
  return new Map(await Promise.all(contents))
}

/**
 * Occlusion and heights have half the side of the normals, as automatic wrinkles write them: only these show how steep a crease is.
 *
 * @param hasHeights whether the layer has heights of its own, which stay.
 */
function encodeMaps({ normal, occlusion, relief }: StrokeMaps, hasHeights: boolean): DrawnFiles {
  const maps = {
    normal: png(encodePortablePng(withoutAlpha({ ...normal, channels: 4 }))),
    occlusion: png(encodePortablePng({ ...halfSide(occlusion), channels: 1 })),
  }
  if (hasHeights) return { maps }
  const { levels, amplitude } = heightLevels(relief.data)
  const height = png(encodePortablePng({ ...halfSide({ ...relief, data: levels }), channels: 1 }))
  return { maps: { ...maps, height }, heightAmplitude: amplitude }
}

function png(bytes: Uint8Array): ImageFile {
  return { mimeType: 'image/png', bytes }
}

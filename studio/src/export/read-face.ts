import { encodeGlb, stripWrinkles, unpackWrinkles, wrinkledFile, wrinkledMaterials } from 'furrow-files'
import { type FaceFiles, type Files, openFace } from '../files/face-files.ts'
import type { OnProgress } from './export-document.ts'

/** A face and its wrinkles, apart. */
export interface ReadFace {
  /** The face without wrinkles, as a `.glb`. */
  face: Uint8Array
  /** Its wrinkles as a project; undefined where it has none. */
  folder?: Files
}

const WHO = 'Studio'

/**
 * Takes the wrinkles of a face out of it, as `furrow unpack` does. `exportDocument` makes the face again.
 *
 * @param options.material its name, where several materials have wrinkles.
 * @throws FurrowError when the face cannot be read, several materials have wrinkles and none is named, or the wrinkles are
 *   damaged.
 */
export async function readFace(
  file: FaceFiles,
  { material }: { material?: string } = {},
  onProgress: OnProgress = () => {},
): Promise<ReadFace> {
  const glb = await openFace(file, WHO)
  if (wrinkledMaterials(glb).length === 0) return { face: encodeGlb(glb) }
  const wrinkled = wrinkledFile(glb, file.name, WHO, material)
  const { files } = await unpackWrinkles(wrinkled, false, WHO, onProgress)
  stripWrinkles(glb, wrinkled.material, WHO)
  return { face: encodeGlb(glb), folder: new Map(files.map(({ path, bytes }) => [path, bytes])) }
}

import { encodeGlb, stripWrinkles, unpackWrinkles, wrinkledFile, wrinkledMaterials } from 'furrow-files'
import { type FaceFiles, type Files, openFace } from '../files/face-files.ts'
import type { OnProgress } from './export-document.ts'

/** Face without wrinkles, and its wrinkles as a folder. */
export interface ReadFace {
  /** `.glb` of the face without wrinkles. */
  face: Uint8Array
  /** Project folder of the wrinkles. Undefined if the face has none. */
  folder?: Files
}

const WHO = 'Studio'

/**
 * Separates a face and its wrinkles, like `furrow unpack`. This is the inverse of `exportDocument`.
 *
 * @param options.material name of the wrinkled material, required if there are several.
 * @throws FurrowError if the face is invalid, the wrinkles are damaged, or the material is ambiguous.
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

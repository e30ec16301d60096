import { type ReadOptions, referenceReader } from '../disk/external-files.ts'
import { readBytes } from '../disk/read-bytes.ts'
import type { Glb } from './glb.ts'
import { checkHead, openGlb } from './glb-file.ts'

/**
 * Reads a `.glb`, `.vrm` or `.gltf` with its referenced files.
 *
 * @throws FurrowError like `openGlb`, and if a file is missing, or a reference is not allowed.
 */
export async function readGlbFile(path: string, who: string, options: ReadOptions = {}): Promise<Glb> {
  const bytes = await readBytes(path, who, 'the face', {
    checkHead: (head, size) => checkHead(head, size, path, who),
  })
  return openGlb(bytes, path, who, referenceReader(path, who, options))
}

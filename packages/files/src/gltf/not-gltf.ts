import { FurrowError } from 'furrow'
import { type FileKind, kindOf } from '../base/file-kind.ts'

const BLENDER = 'open it in Blender and export glTF 2.0 (.glb)'
export const CHOOSE_FACE = 'choose the face file'
const NOT_TEXTURE = 'choose the face file, not a texture'

/** Remedy per kind of file, with an optional note that follows the kind in the error. */
const REMEDIES: { [K in FileKind]?: readonly [remedy: string, note?: string] } = {
  empty: ['download or export it again'],
  'an FBX file': [`convert it with FBX2glTF, or ${BLENDER}`],
  'a USD file': [BLENDER],
  'a USDZ file': [BLENDER],
  'a Blender file': [BLENDER],
  'a PLY file': [BLENDER],
  'a COLLADA file': [BLENDER],
  'an OBJ file': [BLENDER, ', a format without blendshapes'],
  'a pointer of Git LFS': ['fetch the file with git lfs pull', ', not the file itself'],
  'a web page': ['download the file that the page links to'],
  'an archive': ['unpack it first'],
  'an image': [NOT_TEXTURE],
  'a KTX 2 file': [NOT_TEXTURE],
  'a PDF document': [CHOOSE_FACE],
  text: [CHOOSE_FACE, ', not glTF'],
}

/**
 * Recognises a file that is not glTF by its first bytes. Returns an error text and a remedy, or undefined if the kind
 * is unknown.
 */
export function otherFormat(bytes: Uint8Array): { problem: string; remedy: string } | undefined {
  const kind = kindOf(bytes)
  const known = kind && REMEDIES[kind]
  return known && { problem: `it is ${kind}${known[1] ?? ''}`, remedy: known[0] }
}

export function unusable(
  path: string,
  who: string,
  problem: string,
  {
    value,
    remedy = 'download or export it again',
  }: { value?: string | undefined; remedy?: string | undefined } = {},
): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    problem: `${path} is not usable: ${problem}`,
    value,
    limit: 'a complete glTF 2.0 file (.glb, .vrm, .gltf)',
    remedy,
  })
}

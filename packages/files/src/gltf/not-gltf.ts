import { FurrowError } from 'furrow'
import { type FileKind, kindOf } from '../base/file-kind.ts'

const BLENDER = 'open it in Blender and export glTF 2.0 (.glb)'
/** Remedy for a file of another kind. */
export const CHOOSE_FACE = 'choose the face file'
const NOT_TEXTURE = 'choose the face file, not a texture'

/** Remedies for files that are not glTF, with optional notes. */
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

/** Identifies a file that is not glTF by its first bytes, with a remedy. Returns undefined if the kind is unknown. */
export function otherFormat(bytes: Uint8Array): { problem: string; remedy: string } | undefined {
  const kind = kindOf(bytes)
  const known = kind && REMEDIES[kind]
  return known && { problem: `it is ${kind}${known[1] ?? ''}`, remedy: known[0] }
}

/** Creates the error for a file that is not valid glTF 2.0. */
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

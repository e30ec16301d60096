import { FurrowError } from 'furrow'
import { type FileKind, kindOf } from '../base/file-kind.ts'

const BLENDER = 'open it in Blender and export glTF 2.0 (.glb)'
/** What to do about a file that is another than was meant. */
export const NAME_FACE = 'name the face itself'
const NOT_TEXTURE = 'name the face, not one of its textures'

/** What to do about files that are not glTF, and what else there is to say about them. */
const OTHERS: { [K in FileKind]?: readonly [remedy: string, note?: string] } = {
  empty: ['download or export it again'],
  'an FBX file': [`convert it with FBX2glTF, or ${BLENDER}`],
  'a USD file': [BLENDER],
  'a USDZ file': [BLENDER],
  'a Blender file': [BLENDER],
  'a PLY file': [BLENDER],
  'a COLLADA file': [BLENDER],
  'an OBJ file': [BLENDER, ', which has no blendshapes'],
  'a pointer of Git LFS': ['fetch the file with git lfs pull', ', not the file itself'],
  'a web page': ['download the file that the page links to'],
  'an archive': ['unpack it first'],
  'an image': [NOT_TEXTURE],
  'a KTX 2 file': [NOT_TEXTURE],
  'a PDF document': [NAME_FACE],
  text: [NAME_FACE, ', not glTF'],
}

/** Tells by the first bytes what a file is that is not glTF, and what to do about it; undefined where it cannot be told. */
export function otherFormat(bytes: Uint8Array): { problem: string; remedy: string } | undefined {
  const kind = kindOf(bytes)
  const known = kind && OTHERS[kind]
  return known && { problem: `it is ${kind}${known[1] ?? ''}`, remedy: known[0] }
}

/** The error for a file that is not whole glTF 2.0. */
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
    limit: 'a whole glTF 2.0 file (.glb, .vrm, .gltf)',
    remedy,
  })
}

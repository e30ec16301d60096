import { FurrowError } from 'furrow'

/** What a file is that is not glTF, and what to do about it. */
export interface OtherFormat {
  problem: string
  remedy: string
}

const BLENDER = 'open it in Blender and export glTF 2.0 (.glb)'

/** Formats by what their files begin with: one of some texts, or a pattern. Texts are Latin-1. */
const FORMATS: readonly (readonly [begin: readonly string[] | RegExp, problem: string, remedy: string])[] = [
  [['Kaydara FBX Binary', '; FBX '], 'it is an FBX file', `convert it with FBX2glTF, or ${BLENDER}`],
  [['PXR-USDC', '#usda'], 'it is a USD file', BLENDER],
  [['BLENDER'], 'it is a Blender file', BLENDER],
  [['ply\n', 'ply\r'], 'it is a PLY file', BLENDER],
  [/^<\?xml.*<COLLADA/is, 'it is a COLLADA file', BLENDER],
  [/^(#[^\n]*\n|\s)*(mtllib|o|g|v|vn|vt)\s/, 'it is an OBJ file, which has no blendshapes', BLENDER],
  [
    ['version https://git-lfs'],
    'it is a pointer of Git LFS, not the file itself',
    'fetch the file with git lfs pull',
  ],
  [/^\s*(<!doctype html|<html)/i, 'it is a web page', 'download the file that the page links to'],
  [/^PK.{28}[^/]*\.usd/s, 'it is a USDZ file', BLENDER],
  [['PK\x03\x04', '\x1f\x8b', '7z\xbc\xaf', 'Rar!'], 'it is an archive', 'unpack it first'],
  [['\x89PNG', '\xff\xd8\xff', 'RIFF', 'GIF8'], 'it is an image', 'name the face, not one of its textures'],
]

/** Tells by the first bytes what a file is that is not glTF; undefined where it cannot be told. */
export function otherFormat(bytes: Uint8Array): OtherFormat | undefined {
  const head = Buffer.from(bytes.buffer, bytes.byteOffset, Math.min(bytes.length, 1024)).toString('latin1')
  const found = FORMATS.find(([begin]) => {
    return begin instanceof RegExp ? begin.test(head) : begin.some((text) => head.startsWith(text))
  })
  return found && { problem: found[1], remedy: found[2] }
}

/** The error for a file that is not whole glTF 2.0. */
export function unusable(
  path: string,
  who: string,
  problem: string,
  { value, remedy = 'export it again' }: { value?: string | undefined; remedy?: string | undefined } = {},
): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who,
    what: `${path} is not usable: ${problem}`,
    value,
    limit: 'a whole glTF 2.0 file (.glb, .vrm, .gltf)',
    remedy,
  })
}

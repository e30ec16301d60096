import { latin1 } from './bytes.ts'

/** Each kind of file, with the prefixes or the pattern of its first bytes. The bytes are decoded as Latin-1. */
const KINDS = [
  ['a binary glTF file', ['glTF']],
  ['an FBX file', ['Kaydara FBX Binary', '; FBX ']],
  ['a USD file', ['PXR-USDC', '#usda']],
  ['a Blender file', ['BLENDER']],
  ['a PLY file', ['ply\n', 'ply\r']],
  ['a COLLADA file', /^<\?xml.*<COLLADA/is],
  ['an OBJ file', /^(#[^\n]*\n|\s)*(mtllib|o|g|v|vn|vt)\s/],
  ['a pointer of Git LFS', ['version https://git-lfs']],
  ['a web page', /^\s*(<!doctype html|<html)/i],
  ['a USDZ file', /^PK.{28}[^/]*\.usd/s],
  ['an archive', ['PK\x03\x04', '\x1f\x8b', '7z\xbc\xaf', 'Rar!']],
  ['a KTX 2 file', ['\xabKTX 20\xbb']],
  ['a PDF document', ['%PDF-']],
  ['an image', ['\x89PNG', '\xff\xd8\xff', 'GIF8', 'II*\0', 'MM\0*', '8BPS']],
  ['an image', /^(RIFF.{4}WEBP|.{4}ftyp(avif|heic))/s],
  ['an image', /^\s*(<\?xml[^>]*>\s*)?(<!--.*?-->\s*)?<svg/is],
  // Text has no control characters except tabs, line breaks and form feeds.
  // biome-ignore lint/suspicious/noControlCharactersInRegex: control characters distinguish text from other files.
  ['text', /^[^\x00-\x08\x0b\x0e-\x1f\x7f]+$/],
] as const satisfies readonly (readonly [kind: string, begin: readonly string[] | RegExp])[]

/** Kind of a file, e.g. `a PLY file`. */
export type FileKind = (typeof KINDS)[number][0] | 'empty'

/** Number of bytes that `kindOf` reads. */
export const HEAD_BYTES = 1024

/** Identifies a file by its first bytes. Returns undefined if the kind is unknown. */
export function kindOf(bytes: Uint8Array): FileKind | undefined {
  if (bytes.length === 0) return 'empty'
  const head = latin1(bytes.subarray(0, HEAD_BYTES))
  const found = KINDS.find(([, begin]) => {
    return begin instanceof RegExp ? begin.test(head) : begin.some((text) => head.startsWith(text))
  })
  return found?.[0]
}

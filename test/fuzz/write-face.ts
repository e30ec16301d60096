import { type Anything, imageBytes, splitGlb } from './glb-parts.ts'
import type { Random } from './random.ts'

/** URIs that replace those of a `.gltf`: files, inline data, remote resources, invalid paths and other values. */
const URIS: Anything[] = [
  'face%2Ebin',
  'image.png',
  'missing.bin',
  '../face.bin',
  '/etc/passwd',
  'file:///etc/passwd',
  'http://127.0.0.1:1/face.bin',
  'data:,',
  'data:application/octet-stream;base64,AAAA',
  '.',
  '',
  '%',
  'a\0b',
  7,
  null,
]

/**
 * Writes a damaged face, sometimes as a `.gltf` with separate files.
 *
 * @param write writes a file and returns its path.
 */
export function writeFace(
  glb: Buffer,
  random: Random,
  write: (name: string, bytes: Buffer | string) => string,
): string {
  if (random.chance(0.75)) return write('face.glb', glb)
  try {
    const { json, bin } = splitGlb(glb)
    const image = imageBytes({ json, bin }, 0)
    json.buffers[0].uri = 'face.bin'
    json.images[0] = { uri: 'image.png' }
    if (random.chance(0.4)) random.pick([json.buffers[0], json.images[0]]).uri = random.pick(URIS)
    const text = JSON.stringify(json)
    write('face.bin', bin)
    write('image.png', image)
    return write('face.gltf', text)
  } catch {
    // The file is too damaged to split into a `.gltf` and its resources.
    return write('face.glb', glb)
  }
}

import { dirname, join, parse } from 'node:path'
import { concat, utf8 } from '../base/bytes.ts'
import type { OutputFile } from '../base/output-file.ts'
import { type BufferView, compressedViews, type GltfJson } from '../json/gltf-json.ts'
import type { Glb } from './glb.ts'
import { encodeGlb } from './glb-file.ts'

/** File extensions that an output file may have. */
export const FACE_EXTENSIONS = ['.glb', '.vrm', '.gltf'] as const

/** File extension per MIME type. Images with another type stay in the binary buffer. */
const IMAGE_EXTENSIONS: Readonly<Record<string, string>> = {
  'image/png': 'png',
  'image/jpeg': 'jpg',
  'image/webp': 'webp',
  'image/avif': 'avif',
  'image/ktx2': 'ktx2',
}

/**
 * Returns the files to write for a glTF file. For `.glb` and `.vrm` this is one file. For `.gltf` it is the JSON, a
 * binary buffer, and one file per image, all in one folder.
 *
 * @param isFree returns whether a buffer or image may be written to a path. If not, a file name with the next
 *   number is tried.
 */
export function filesOfFace(
  glb: Glb,
  path: string,
  isFree: (path: string) => boolean = () => true,
): OutputFile[] {
  return path.toLowerCase().endsWith('.gltf')
    ? splitFile(glb, path, isFree)
    : [{ path, bytes: encodeGlb(glb) }]
}

function splitFile(glb: Glb, path: string, isFree: (path: string) => boolean): OutputFile[] {
  const { name } = parse(path)
  const beside = (file: string) => join(dirname(path), file)
  let count = 0
  const numbered = (extension: string): string => {
    const file = `${name}-${++count}.${extension}`
    return isFree(beside(file)) ? file : numbered(extension)
  }
  const json = structuredClone(glb.json)
  const files: OutputFile[] = []
  const images = imageViews(json)
  for (const [view, users] of images) {
    const { byteOffset = 0, byteLength } = json.bufferViews![view]
    const file = numbered(IMAGE_EXTENSIONS[users[0].mimeType!])
    files.push({ path: beside(file), bytes: glb.bin.subarray(byteOffset, byteOffset + byteLength) })
    for (const image of users) {
      delete image.bufferView
      image.uri = encodeURIComponent(file)
    }
  }
  const bin = removeViews(json, glb.bin, images)
  if (bin.length > 0) {
    const file = isFree(beside(`${name}.bin`)) ? `${name}.bin` : numbered('bin')
    Object.assign(json.buffers![0], { uri: encodeURIComponent(file), byteLength: bin.length })
    files.push({ path: beside(file), bytes: bin })
  }
  files.push({ path, bytes: utf8(`${JSON.stringify(json, null, 2)}\n`) })
  return files
}

type Image = NonNullable<GltfJson['images']>[number]

/**
 * Finds the buffer views that contain nothing but an image with a known MIME type. Returns the images that use each
 * buffer view.
 */
function imageViews(json: GltfJson): Map<number, Image[]> {
  const views = new Map<number, Image[]>()
  for (const image of json.images ?? []) {
    if (image.bufferView === undefined || !(image.mimeType! in IMAGE_EXTENSIONS)) continue
    const users = views.get(image.bufferView) ?? []
    users.push(image)
    views.set(image.bufferView, users)
  }
  const uses = new Map<number, number>()
  changeViews(json, (index) => {
    uses.set(index, (uses.get(index) ?? 0) + 1)
    return index
  })
  for (const [index, users] of views) {
    if (uses.get(index) !== users.length || json.bufferViews?.[index]?.buffer !== 0) views.delete(index)
  }
  return views
}

/** Removes buffer views from the JSON. Returns the binary chunk without their bytes. */
function removeViews(json: GltfJson, bin: Uint8Array, removed: ReadonlyMap<number, unknown>): Uint8Array {
  if (!json.bufferViews) return bin
  const moved = new Map<number, number>()
  const kept = json.bufferViews.filter((_, i) => {
    if (removed.has(i)) return false
    moved.set(i, moved.size)
    return true
  })
  changeViews(json, (index) => moved.get(index) ?? index)
  const views = kept.flatMap((view) => [view, ...compressedViews(view)])
  json.bufferViews = kept
  return gather(
    views.filter(({ buffer }) => buffer === 0),
    bin,
  )
}

/**
 * Closes gaps between buffer views. Offsets keep their remainder modulo 4, and overlapping views still overlap. Returns
 * the new binary chunk.
 */
function gather(views: readonly BufferView[], bin: Uint8Array): Uint8Array {
  const parts: Uint8Array[] = []
  let [length, end, shift] = [0, 0, 0]
  for (const view of [...views].sort((a, b) => (a.byteOffset ?? 0) - (b.byteOffset ?? 0))) {
    const { byteOffset = 0, byteLength } = view
    if (byteOffset >= end) {
      const gap = (4 + ((byteOffset - length) % 4)) % 4
      parts.push(new Uint8Array(gap))
      length += gap
      shift = length - byteOffset
      end = byteOffset
    }
    const rest = bin.subarray(end, Math.max(end, byteOffset + byteLength))
    parts.push(rest)
    length += rest.length
    end += rest.length
    // After the gaps are closed, an empty last buffer view would start at the end of the buffer, i.e. outside it.
    view.byteOffset = byteLength === 0 ? 0 : byteOffset + shift
  }
  return concat(parts)
}

/** Replaces every `bufferView` index in the JSON, also in unknown extensions. */
function changeViews(value: unknown, change: (index: number) => number): void {
  if (typeof value !== 'object' || value === null) return
  for (const [key, item] of Object.entries(value)) {
    if (key === 'bufferView' && typeof item === 'number') Object.assign(value, { bufferView: change(item) })
    else changeViews(item, change)
  }
}

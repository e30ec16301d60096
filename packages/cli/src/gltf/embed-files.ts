import { stat } from 'node:fs/promises'
import { posix } from 'node:path'
import { FurrowError } from 'furrow'
import { checkFileBytes } from '../inputs.ts'
import { BufferViewWriter } from './buffer-view-writer.ts'
import { type ReadOptions, readUri, resolveInside } from './external-files.ts'
import type { Glb } from './glb-file.ts'
import { compressedViews } from './gltf-json.ts'
import { imageTypeOf } from './image-type.ts'

/** Reads what a URI refers to; the same object where it is the same file. */
type Read = (uri: string) => Promise<Uint8Array>

/**
 * Makes a file whole: the buffers and images that it refers to become part of its binary chunk. A file that refers to
 * none is not changed.
 *
 * @param glb changed in place; all indices but those of buffers stay valid.
 * @param path of the file that it was read from.
 * @throws FurrowError at the first file that cannot be read, see `resolveInside`, or is cut off.
 */
export async function embedFiles(
  glb: Glb,
  path: string,
  who: string,
  options: ReadOptions = {},
): Promise<void> {
  const { buffers = [], images = [] } = glb.json
  if (![...buffers, ...images].some(({ uri }) => uri !== undefined)) return
  const known = new Map<string, Uint8Array>()
  const read = async (uri: string) => {
    const key = uri.startsWith('data:') ? uri : await resolveInside(path, uri, who, options)
    const found = known.get(key)
    if (found) return found
    if (key !== uri) {
      glb.fileBytes += (await stat(key)).size
      glb.files.push(key)
      checkFileBytes(glb.fileBytes, `the face ${path} with the files that it refers to`, who)
    }
    const bytes = await readUri(path, uri, who, options)
    known.set(key, bytes)
    return bytes
  }
  glb.bin = await joinBuffers(glb, read, path, who)
  if (images.some(({ uri }) => uri !== undefined)) await embedImages(glb, read, path, who)
}

/** Joins all buffers that have data to the first one; those without are fallbacks of compressed meshes. */
async function joinBuffers(
  { json, ...glb }: Glb,
  read: Read,
  path: string,
  who: string,
): Promise<Uint8Array> {
  const { buffers = [], bufferViews = [] } = json
  const parts = new Map<Uint8Array, number>()
  const fallbacks: typeof buffers = []
  let byteLength = 0
  const moved: { buffer: number; offset: number }[] = []
  for (const [i, buffer] of buffers.entries()) {
    if (buffer.uri === undefined && (i > 0 || glb.bin.length === 0)) {
      moved.push({ buffer: fallbacks.push(buffer), offset: 0 })
      continue
    }
    const bytes = buffer.uri === undefined ? glb.bin : await read(buffer.uri)
    if (bytes.length < buffer.byteLength) {
      throw damaged(path, who, `buffers[${i}] has ${bytes.length} of ${buffer.byteLength} bytes`, buffer.uri)
    }
    const offset = parts.get(bytes) ?? 4 * Math.ceil(byteLength / 4)
    if (!parts.has(bytes)) byteLength = offset + bytes.length
    parts.set(bytes, offset)
    moved.push({ buffer: 0, offset })
  }
  for (const [i, view] of bufferViews.entries()) {
    for (const part of [view, ...compressedViews(view)]) {
      const place = moved[part.buffer]
      const end = (part.byteOffset ?? 0) + part.byteLength
      if (!place || end > buffers[part.buffer].byteLength) {
        throw damaged(path, who, `bufferViews[${i}] is not within its buffer`)
      }
      part.buffer = place.buffer
      if (place.offset > 0) part.byteOffset = (part.byteOffset ?? 0) + place.offset
    }
  }
  json.buffers = [{ byteLength }, ...fallbacks]
  const joined = new Uint8Array(byteLength)
  for (const [bytes, offset] of parts) joined.set(bytes, offset)
  return joined
}

async function embedImages(glb: Glb, read: Read, path: string, who: string): Promise<void> {
  const writer = new BufferViewWriter(glb)
  const views = new Map<Uint8Array, number>()
  for (const image of glb.json.images ?? []) {
    const { uri } = image
    if (uri === undefined) continue
    const bytes = await read(uri)
    const mimeType = imageTypeOf(bytes) ?? image.mimeType
    if (mimeType === undefined) {
      throw new FurrowError({
        code: 'unreadable',
        who,
        what: `an image of ${path} is in an unknown format`,
        value: uri,
        limit: 'PNG, JPEG, WebP, AVIF, KTX 2',
        remedy: 'convert it to PNG',
      })
    }
    const bufferView = views.get(bytes) ?? writer.add(bytes)
    views.set(bytes, bufferView)
    delete image.uri
    if (!uri.startsWith('data:')) image.name ??= posix.parse(uri).name
    Object.assign(image, { mimeType, bufferView })
  }
  writer.finish()
}

function damaged(path: string, who: string, problem: string, value?: string): FurrowError {
  const what = `${path} is not usable: ${problem}`
  return new FurrowError({ code: 'unreadable', who, what, value, remedy: 'export it again' })
}

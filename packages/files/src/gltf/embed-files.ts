import { FurrowError } from 'furrow'
import { imageTypeOf } from 'furrow/internal'
import type { ReadReference, Reference } from '../base/references.ts'
import { compressedViews } from '../json/gltf-json.ts'
import { BufferViewWriter } from './buffer-view-writer.ts'
import type { Glb } from './glb.ts'
import { unusable } from './not-gltf.ts'

/**
 * Copies all referenced buffers and images into the binary chunk. Does not change a file without references.
 *
 * @param glb changed in place. All indices stay valid, except those of buffers.
 * @param path path of the source file, for errors.
 * @throws FurrowError if a referenced file cannot be read, or is shorter than its buffer's `byteLength`.
 */
export async function embedFiles(glb: Glb, path: string, who: string, read: ReadReference): Promise<void> {
  const { buffers = [], images = [] } = glb.json
  const uris = [...buffers, ...images].flatMap(({ uri }) => uri ?? [])
  if (uris.length === 0) return
  const references = new Map<string, Reference>()
  for (const uri of uris) references.set(uri, references.get(uri) ?? (await read(uri)))
  for (const { bytes, path } of new Set(references.values())) if (path) glb.fileBytes += bytes.length
  glb.references = references
  glb.bin = joinBuffers(glb, path, who)
  if (images.some(({ uri }) => uri !== undefined)) embedImages(glb, path, who)
}

/**
 * Joins all buffers that have data, and returns the binary chunk. Buffers without data stay separate: they are the
 * fallbacks of compressed buffer views.
 */
function joinBuffers({ json, references, ...glb }: Glb, path: string, who: string): Uint8Array {
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
    const bytes = buffer.uri === undefined ? glb.bin : references.get(buffer.uri)!.bytes
    if (bytes.length < buffer.byteLength) {
      const problem = `buffers[${i}] has ${bytes.length} of ${buffer.byteLength} bytes`
      throw unusable(path, who, problem, { value: buffer.uri })
    }
    const offset = parts.get(bytes) ?? 4 * Math.ceil(byteLength / 4)
    if (!parts.has(bytes)) byteLength = offset + bytes.length
    parts.set(bytes, offset)
    moved.push({ buffer: 0, offset })
  }
  for (const [i, view] of bufferViews.entries()) {
    for (const part of [view, ...compressedViews(view)]) {
      const target = moved[part.buffer]
      const end = (part.byteOffset ?? 0) + part.byteLength
      if (!target || end > buffers[part.buffer].byteLength) {
        throw unusable(path, who, `bufferViews[${i}] is not within its buffer`)
      }
      part.buffer = target.buffer
      if (target.offset > 0) part.byteOffset = (part.byteOffset ?? 0) + target.offset
    }
  }
  json.buffers = [{ byteLength }, ...fallbacks]
  const joined = new Uint8Array(byteLength)
  for (const [bytes, offset] of parts) joined.set(bytes, offset)
  return joined
}

function embedImages(glb: Glb, path: string, who: string): void {
  const writer = new BufferViewWriter(glb)
  const views = new Map<Uint8Array, number>()
  for (const image of glb.json.images ?? []) {
    const { uri } = image
    if (uri === undefined) continue
    const { bytes, path: file } = glb.references.get(uri)!
    const mimeType = imageTypeOf(bytes) ?? image.mimeType
    if (mimeType === undefined) {
      throw new FurrowError({
        code: 'unreadable',
        who,
        problem: `an image of ${path} is in an unknown format`,
        value: uri,
        limit: 'PNG, JPEG, WebP, AVIF, KTX 2',
        remedy: 'convert it to PNG',
      })
    }
    const bufferView = views.get(bytes) ?? writer.add(bytes)
    views.set(bytes, bufferView)
    delete image.uri
    if (file !== undefined) image.name ??= nameOf(uri)
    Object.assign(image, { mimeType, bufferView })
  }
  writer.finish()
}

function nameOf(uri: string): string {
  const file = uri.replace(/\/+$/, '').replace(/^.*\//s, '')
  return file.replace(/(?<=.)\.[^.]*$/s, '')
}

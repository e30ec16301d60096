/** JSON of any shape. */
// biome-ignore lint/suspicious/noExplicitAny: the fuzzer breaks JSON in ways that no type allows
export type Anything = any

/** Parts of a `.glb`, read without checks. */
export interface GlbParts {
  json: Anything
  bin: Buffer
}

export function splitGlb(glb: Buffer): GlbParts {
  const end = 20 + glb.readUInt32LE(12)
  return { json: JSON.parse(glb.toString('utf8', 20, end)), bin: Buffer.from(glb.subarray(end + 8)) }
}

/**
 * Writes a `.glb`.
 *
 * @param text JSON chunk; default: the serialised `json`.
 */
export function joinGlb({ json, bin }: GlbParts, text = JSON.stringify(json)): Buffer {
  const chunk = (type: number, data: Buffer, fill: number) => {
    const head = Buffer.alloc(8)
    const gap = (4 - (data.length % 4)) % 4
    head.writeUInt32LE(data.length + gap, 0)
    head.writeUInt32LE(type, 4)
    return Buffer.concat([head, data, Buffer.alloc(gap, fill)])
  }
  const body = Buffer.concat([chunk(0x4e4f534a, Buffer.from(text), 0x20), chunk(0x004e4942, bin, 0)])
  const head = Buffer.from('glTF\x02\0\0\0\0\0\0\0', 'latin1')
  head.writeUInt32LE(12 + body.length, 8)
  return Buffer.concat([head, body])
}

/** Replaces the bytes of an image in a file. */
export function setImage({ json, bin }: GlbParts, image: number, bytes: Buffer, mimeType?: string): GlbParts {
  const start = Math.ceil(bin.length / 4) * 4
  const bufferView = json.bufferViews.push({ buffer: 0, byteOffset: start, byteLength: bytes.length }) - 1
  json.images[image] = { ...json.images[image], bufferView, ...(mimeType && { mimeType }) }
  json.buffers[0].byteLength = start + bytes.length
  return { json, bin: Buffer.concat([bin, Buffer.alloc(start - bin.length), bytes]) }
}

/** Returns the bytes of an image in a file. */
export function imageBytes({ json, bin }: GlbParts, image: number): Buffer {
  const { byteOffset = 0, byteLength } = json.bufferViews[json.images[image].bufferView]
  return Buffer.from(bin.subarray(byteOffset, byteOffset + byteLength))
}

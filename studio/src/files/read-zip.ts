/** Entry of a .zip archive, from the central directory. */
export interface ZipEntry {
  path: string
  /** Compression method: 0 for stored, 8 for deflate. */
  method: number
  /** Offset of the entry's local header in the archive, bytes. */
  start: number
  /** Compressed size in the archive, bytes. */
  size: number
  /** Uncompressed size, bytes. */
  length: number
}

// Signatures and sizes of records, from APPNOTE.TXT of PKWARE, section 4.3.
const LOCAL = 0x04034b50
const CENTRAL = 0x02014b50
const END = 0x06054b50
const END_64 = 0x06064b50
const LOCATOR_64 = 0x07064b50
const END_BYTES = 22
const MAX_COMMENT = 0xffff
/** Placeholder for a number that does not fit into 32 bits and is stored in the zip64 field instead. */
const MISSING = 0xffffffff

const ENCRYPTED = 1
const UTF_8 = 0x800

/** Lists the entries of an archive. Throws Error if the file is no .zip, its central directory is damaged, or an entry is encrypted. */
export function* zipEntries(bytes: Uint8Array): Generator<ZipEntry> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  let { at, count } = listOf(view)
  for (; count > 0; count--) {
    if (view.getUint32(at, true) !== CENTRAL) throw new Error('its list of files is damaged')
    const flags = view.getUint16(at + 8, true)
    const [nameLength, extraLength, commentLength] = [28, 30, 32].map((field) =>
      view.getUint16(at + field, true),
    )
    const name = bytes.subarray(at + 46, at + 46 + nameLength)
    const path = new TextDecoder(flags & UTF_8 ? 'utf-8' : 'latin1').decode(name)
    if (flags & ENCRYPTED) throw new Error(`${path} is encrypted`)
    const numbers = [24, 20, 42].map((field) => view.getUint32(at + field, true))
    const extra = at + 46 + nameLength
    const [length, size, start] = wideNumbers(view, numbers, extra, extra + extraLength)
    yield { path, method: view.getUint16(at + 10, true), start, size, length }
    at = extra + extraLength + commentLength
  }
}

/**
 * Unpacks an entry in chunks, so that an entry with more bytes than declared fails before it fills the memory.
 *
 * @throws Error if the entry is damaged, or its size is wrong.
 */
export async function unpackEntry(bytes: Uint8Array<ArrayBuffer>, entry: ZipEntry): Promise<Blob> {
  const { path, method, start, size, length } = entry
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)
  if (view.getUint32(start, true) !== LOCAL) throw new Error(`${path} is damaged`)
  const from = start + 30 + view.getUint16(start + 26, true) + view.getUint16(start + 28, true)
  const packed = bytes.subarray(from, from + size)
  if (packed.length !== size) throw new Error(`${path} is cut off`)
  if (method !== 0 && method !== 8) throw new Error(`${path} is compressed by method ${method}`)
  const chunks = method === 0 ? [packed] : inflate(packed)
  const parts: Uint8Array<ArrayBuffer>[] = []
  let count = 0
  for await (const chunk of chunks) {
    count += chunk.length
    if (count > length) throw new Error(`${path} has more bytes than it says`)
    parts.push(chunk)
  }
  if (count !== length) throw new Error(`${path} has ${count} of ${length} bytes`)
  return new Blob(parts)
}

async function* inflate(packed: Uint8Array<ArrayBuffer>): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'))
  const reader = stream.getReader()
  try {
    for (let { done, value } = await reader.read(); !done; { done, value } = await reader.read()) {
      yield value as Uint8Array<ArrayBuffer>
    }
  } finally {
    await reader.cancel().catch(() => {})
  }
}

/** Returns the offset of the central directory and its number of entries. */
function listOf(view: DataView): { at: number; count: number } {
  const last = view.byteLength - END_BYTES
  for (let end = last; end >= Math.max(0, last - MAX_COMMENT); end--) {
    if (view.getUint32(end, true) !== END) continue
    const [count, at] = [view.getUint16(end + 10, true), view.getUint32(end + 16, true)]
    if (count !== 0xffff && at !== MISSING) return { at, count }
    const locator = end - 20
    if (locator < 0 || view.getUint32(locator, true) !== LOCATOR_64) return { at, count }
    const wide = number64(view, locator + 8)
    if (view.getUint32(wide, true) !== END_64) throw new Error('its list of files is damaged')
    return { at: number64(view, wide + 48), count: number64(view, wide + 32) }
  }
  throw new Error('it is not a .zip, or cut off')
}

/** Replaces each number that is `MISSING` by the next number of the zip64 field. */
function wideNumbers(view: DataView, numbers: readonly number[], from: number, to: number): number[] {
  for (let at = from; at + 4 <= to; at += 4 + view.getUint16(at + 2, true)) {
    if (view.getUint16(at, true) !== 1) continue
    let next = at + 4
    return numbers.map((number) => {
      if (number !== MISSING) return number
      next += 8
      return number64(view, next - 8)
    })
  }
  return [...numbers]
}

const number64 = (view: DataView, at: number) => Number(view.getBigUint64(at, true))

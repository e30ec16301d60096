/**
 * Caches generated wrinkles in the browser's Cache Storage. The results of a character are compressed and stored under a hash of the input.
 * The cache contains at most 32 characters, all of the same version of the code.
 *
 * Cache Storage is simpler to use than IndexedDB, because it needs no schema and no transactions. Cache Storage can be
 * unavailable: for example, over HTTP, in private windows, or if the disk is full. Then nothing is cached, and no error is reported.
 */

const PREFIX = 'furrow-auto-'
const MAX_ENTRIES = 32

/**
 * Computes the hexadecimal SHA-256 of data that `pack` accepts. Returns undefined on pages loaded over HTTP, where browsers do not offer
 * `crypto.subtle`.
 */
export async function keyOf(data: unknown): Promise<string | undefined> {
  if (!globalThis.crypto?.subtle) return undefined
  const hash = await crypto.subtle.digest('SHA-256', await pack(data).arrayBuffer())
  return Array.from(new Uint8Array(hash), (byte) => byte.toString(16).padStart(2, '0')).join('')
}

/** Returns the cached results of a key in their order, or undefined if there are none or they cannot be read. */
export async function recall(version: string, key: string | undefined): Promise<unknown[] | undefined> {
  if (key === undefined) return undefined
  try {
    const found = await (await caches.open(PREFIX + version)).match(addressOf(key))
    return found && unpackAll(await expand(found))
  } catch {
    return undefined
  }
}

/**
 * Caches results under a key.
 *
 * @param packed results that `pack` has copied.
 */
export async function keep(version: string, key: string | undefined, packed: readonly Blob[]): Promise<void> {
  if (key === undefined) return
  try {
    for (const name of await caches.keys()) {
      if (name.startsWith(PREFIX) && name !== PREFIX + version) await caches.delete(name)
    }
    const cache = await caches.open(PREFIX + version)
    const oldest = (await cache.keys()).slice(0, 1 - MAX_ENTRIES)
    for (const request of oldest) await cache.delete(request)
    const sizes = new Float64Array([packed.length, ...packed.map(({ size }) => size)])
    await cache.put(addressOf(key), compress(new Blob([sizes, ...packed])))
  } catch {
    // Caching is optional. If it fails, the next visit generates the data again.
  }
}

/** Converts a key to a URL, because Cache Storage requires URLs as keys. The URL is never requested. */
function addressOf(key: string): string {
  return `https://furrow.invalid/${key}`
}

function compress(blob: Blob): Response {
  return new Response(blob.stream().pipeThrough(new CompressionStream('gzip')))
}

function expand({ body }: Response): Promise<ArrayBuffer> {
  return new Response(body!.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer()
}

const ARRAYS = { Uint8Array, Uint16Array, Uint32Array, Float32Array, Float64Array }

/**
 * Packs JSON data that may contain typed arrays into bytes. The bytes are a copy, so the caller may transfer the arrays. They consist of the
 * length of a JSON text, the JSON text, and the typed arrays. Each part is padded to a multiple of 8 bytes. In the JSON text,
 * `{ array: TYPE, length }` stands for a typed array.
 */
export function pack(data: unknown): Blob {
  const parts: BlobPart[] = []
  const json = JSON.stringify(data, (_, value) => {
    if (!ArrayBuffer.isView(value)) return value
    const array = value as Uint8Array<ArrayBuffer>
    parts.push(array, new Uint8Array(-array.byteLength & 7))
    return { array: array[Symbol.toStringTag], length: array.length }
  })
  const text = new TextEncoder().encode(json)
  return new Blob([new Float64Array([text.length]), text, new Uint8Array(-text.length & 7), ...parts])
}

function unpack(buffer: ArrayBuffer, start: number): unknown {
  const [length] = new Float64Array(buffer, start, 1)
  const text = new Uint8Array(buffer, start + 8, length)
  let at = start + 8 + length + (-length & 7)
  return JSON.parse(new TextDecoder().decode(text), (_, value) => {
    const Type = ARRAYS[value?.array as keyof typeof ARRAYS]
    if (!Type) return value
    // Each array gets a separate buffer, so that it can be transferred to another thread.
    const array = new Type(buffer.slice(at, at + value.length * Type.BYTES_PER_ELEMENT))
    at += array.byteLength + (-array.byteLength & 7)
    return array
  })
}

function unpackAll(buffer: ArrayBuffer): unknown[] {
  const [count] = new Float64Array(buffer, 0, 1)
  let at = 8 * (1 + count)
  return Array.from(new Float64Array(buffer, 8, count), (size) => {
    const data = unpack(buffer, at)
    at += size
    return data
  })
}

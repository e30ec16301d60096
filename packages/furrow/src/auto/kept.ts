/**
 * Caches results in the browser's Cache Storage, compressed, by a hash of their input: at most 32 results of one version of the code.
 * Cache Storage is simpler than IndexedDB (no schema, no transactions) and as well supported. Some pages have neither (plain HTTP, private
 * windows, blocked storage, a full disk); nothing is cached there, without an error.
 */

const PREFIX = 'furrow-auto-'
const MAX_ENTRIES = 32

/** Computes the SHA-256 of plain data with typed arrays, in hexadecimal; undefined over plain HTTP, which has no `crypto.subtle`. */
export async function keyOf(data: unknown): Promise<string | undefined> {
  if (!globalThis.crypto?.subtle) return undefined
  const hash = await crypto.subtle.digest('SHA-256', await pack(data).arrayBuffer())
  return Array.from(new Uint8Array(hash), (byte) => byte.toString(16).padStart(2, '0')).join('')
}

/** Returns the cached data of a key; undefined if missing or unreadable. */
export async function recall<T>(version: string, key: string | undefined): Promise<T | undefined> {
  if (key === undefined) return undefined
  try {
    const found = await (await caches.open(PREFIX + version)).match(addressOf(key))
    return found && (unpack(await expand(found)) as T)
  } catch {
    return undefined
  }
}

/**
 * Caches data under a key.
 *
 * @param copied called after the data is copied, when it may be modified or transferred.
 */
export async function keep(
  version: string,
  key: string | undefined,
  data: unknown,
  copied: () => void,
): Promise<void> {
  const blob = key !== undefined && pack(data)
  copied()
  if (!blob) return
  try {
    for (const name of await caches.keys()) {
      if (name.startsWith(PREFIX) && name !== PREFIX + version) await caches.delete(name)
    }
    const cache = await caches.open(PREFIX + version)
    const oldest = (await cache.keys()).slice(0, 1 - MAX_ENTRIES)
    for (const request of oldest) await cache.delete(request)
    await cache.put(addressOf(key), compress(blob))
  } catch {
    // Without a cache, the data is made again.
  }
}

/** Returns a URL, which Cache Storage requires as the key; it is never requested. */
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
 * Packs data as the length of the JSON, the JSON and the arrays, each aligned to 8 bytes. In the JSON, a typed array is
 * `{ array: TYPE, length }`.
 */
function pack(data: unknown): Blob {
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

function unpack(buffer: ArrayBuffer): unknown {
  const [length] = new Float64Array(buffer, 0, 1)
  let at = 8 + length + (-length & 7)
  return JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length)), (_, value) => {
    const Type = ARRAYS[value?.array as keyof typeof ARRAYS]
    if (!Type) return value
    // A separate buffer, which can be transferred.
    const array = new Type(buffer.slice(at, at + value.length * Type.BYTES_PER_ELEMENT))
    at += array.byteLength + (-array.byteLength & 7)
    return array
  })
}

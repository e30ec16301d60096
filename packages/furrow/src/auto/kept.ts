/**
 * What was made is kept in the browser's Cache Storage, compressed, by the content that it was made from: 32 results at most, and only of one
 * version of the code. Cache Storage is simpler than IndexedDB (no schema, no transactions, an entry is there or not), and as well supported.
 * Both are missing or refuse in some pages (plain HTTP, private windows, blocked storage, a full disk): nothing is then kept, and nothing
 * fails.
 */

const PREFIX = 'furrow-auto-'
const MOST_ENTRIES = 32

/** SHA-256 of plain data with typed arrays, in hexadecimal; undefined on a page over plain HTTP, which has neither hashes nor a cache. */
export async function keyOf(data: unknown): Promise<string | undefined> {
  if (!globalThis.crypto?.subtle) return undefined
  const hash = await crypto.subtle.digest('SHA-256', await pack(data).arrayBuffer())
  return Array.from(new Uint8Array(hash), (byte) => byte.toString(16).padStart(2, '0')).join('')
}

/** What is kept under a key; undefined where there is nothing, or nothing that can be read. */
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
 * Keeps data under a key.
 *
 * @param copied is called when the data was copied, and may be changed or transferred.
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
    const oldest = (await cache.keys()).slice(0, 1 - MOST_ENTRIES)
    for (const request of oldest) await cache.delete(request)
    await cache.put(addressOf(key), compress(blob))
  } catch {
    // It is made again the next time.
  }
}

/** The cache takes addresses of the web only; this one never is requested. */
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

/** The length of the JSON, the JSON, in which each typed array is `{ array: its type, length }`, and the arrays, each at a multiple of 8 bytes. */
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
    // A buffer of its own, which can be transferred.
    const array = new Type(buffer.slice(at, at + value.length * Type.BYTES_PER_ELEMENT))
    at += array.byteLength + (-array.byteLength & 7)
    return array
  })
}

// biome-ignore lint/suspicious/noExplicitAny: tests break the JSON in ways that no type allows
type Json = any

/** Reads the JSON of a binary glTF file without checks. */
export function jsonOf(file: Uint8Array): Json {
  return JSON.parse(new TextDecoder().decode(file.subarray(20, endOfJson(file))))
}

/** Returns a copy of a binary glTF file with its JSON replaced. */
export function withJson(file: Uint8Array, json: Json): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json))
  const padded = Math.ceil(text.length / 4) * 4
  const rest = file.subarray(endOfJson(file))
  const out = new Uint8Array(20 + padded + rest.length).fill(0x20, 20, 20 + padded)
  out.set(file.subarray(0, 20))
  out.set(text, 20)
  out.set(rest, 20 + padded)
  const view = new DataView(out.buffer)
  view.setUint32(8, out.length, true)
  view.setUint32(12, padded, true)
  return out
}

/** Returns a copy of a binary glTF file with its JSON edited. */
export function editGlb(file: Uint8Array, edit: (json: Json) => unknown): Uint8Array<ArrayBuffer> {
  const json = jsonOf(file)
  edit(json)
  return withJson(file, json)
}

function endOfJson(file: Uint8Array): number {
  return 20 + new DataView(file.buffer, file.byteOffset).getUint32(12, true)
}

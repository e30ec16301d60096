/** Edits the JSON of a binary glTF file without any checks. */
// biome-ignore lint/suspicious/noExplicitAny: tests break the JSON in ways that no type allows
export function editGlb(file: Uint8Array, edit: (json: any) => unknown): Uint8Array<ArrayBuffer> {
  const length = new DataView(file.buffer, file.byteOffset).getUint32(12, true)
  const json = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length)))
  edit(json)
  const text = new TextEncoder().encode(JSON.stringify(json))
  const padded = Math.ceil(text.length / 4) * 4
  const out = new Uint8Array(20 + padded + file.length - 20 - length).fill(0x20, 20, 20 + padded)
  out.set(file.subarray(0, 20))
  out.set(text, 20)
  out.set(file.subarray(20 + length), 20 + padded)
  const view = new DataView(out.buffer)
  view.setUint32(8, out.length, true)
  view.setUint32(12, padded, true)
  return out
}

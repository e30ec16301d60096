/** Encodes RGBA bytes as an uncompressed TGA image, bottom row first, as most programs write it. */
export function tga(size: number, rgba: Uint8Array): Uint8Array {
  const file = new Uint8Array(18 + 4 * size * size)
  const view = new DataView(file.buffer)
  file[2] = 2
  view.setUint16(12, size, true)
  view.setUint16(14, size, true)
  file[16] = 32
  file[17] = 8
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      const from = 4 * (row * size + column)
      const to = 18 + 4 * ((size - 1 - row) * size + column)
      file.set([rgba[from + 2]!, rgba[from + 1]!, rgba[from]!, rgba[from + 3]!], to)
    }
  }
  return file
}

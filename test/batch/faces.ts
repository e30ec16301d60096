import { sheet, sheetGlb } from '../unit/cli/sheet.ts'

/** Small faces, no two of which are the same bytes. */
export function makeFaces(count: number): Promise<Uint8Array[]> {
  return Promise.all(
    Array.from({ length: count }, (_, i) => {
      const shape = sheet(20)
      shape.positions[0] -= i * 1e-5
      return sheetGlb(shape)
    }),
  )
}

/** Whether bytes are a whole binary glTF, which says its own length. */
export function isWhole(bytes: Buffer): boolean {
  return bytes.toString('latin1', 0, 4) === 'glTF' && bytes.readUInt32LE(8) === bytes.length
}

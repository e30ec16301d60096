import { sheet, sheetGlb } from '../unit/cli/sheet.ts'

/** Makes small `.glb` faces that all differ. */
export function makeFaces(count: number): Promise<Uint8Array[]> {
  return Promise.all(
    Array.from({ length: count }, (_, i) => {
      const shape = sheet(20)
      shape.positions[0] -= i * 1e-5
      return sheetGlb(shape)
    }),
  )
}

/** Tells whether a binary glTF has the length given in its header. */
export function isCompleteGlb(bytes: Buffer): boolean {
  return bytes.toString('latin1', 0, 4) === 'glTF' && bytes.readUInt32LE(8) === bytes.length
}

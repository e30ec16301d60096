import type { Inspection } from './inspect.ts'

/** Cost of the wrinkles in a file, in bytes. */
export interface Cost {
  /** Images and strokes in the file. */
  file: number
  /** Maps, areas and one influence map on a desktop GPU. Compressed maps become BC1 there. */
  gpu: number
  /** Same as `gpu` on a phone, where compressed maps become ASTC 4x4. */
  phone: number
}

/** Computes the cost of automatic wrinkles from the report of `inspectWrinkles`. */
export function costOf({ imageBytes, strokes, gpu, influenceMapBytes }: Inspection, ktx2: boolean): Cost {
  return {
    file: imageBytes + strokes.bytes,
    gpu: (ktx2 ? gpu.bits4 : gpu.uncompressed) + influenceMapBytes,
    phone: (ktx2 ? gpu.bits8 : gpu.uncompressed) + influenceMapBytes,
  }
}

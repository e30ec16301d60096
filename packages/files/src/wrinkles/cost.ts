import type { Inspection } from './inspect.ts'

/** What the wrinkles of a file cost, in bytes. */
export interface Cost {
  /** Of their images and strokes in the file. */
  file: number
  /** Of their maps, areas and one influence map on a GPU: of a desktop, where maps that are compressed become BC1. */
  gpu: number
  /** The same on a phone, where they become ASTC 4x4. */
  phone: number
}

/** What automatic wrinkles cost, as `furrow inspect` counts them. */
export function costOf({ imageBytes, strokes, gpu, influenceMapBytes }: Inspection, ktx2: boolean): Cost {
  return {
    file: imageBytes + strokes.bytes,
    gpu: (ktx2 ? gpu.bits4 : gpu.uncompressed) + influenceMapBytes,
    phone: (ktx2 ? gpu.bits8 : gpu.uncompressed) + influenceMapBytes,
  }
}

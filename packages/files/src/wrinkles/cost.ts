import type { Inspection } from './inspect.ts'

/** Storage and GPU memory of the wrinkles in a file, bytes. */
export interface Cost {
  /** Size of the images and strokes in the file. */
  file: number
  /** GPU memory of maps, areas and one influence map on a desktop GPU, where KTX 2 maps become BC1. */
  gpu: number
  /** GPU memory on a phone, where KTX 2 maps become ASTC 4x4. */
  phone: number
}

/**
 * Computes the cost of automatic wrinkles from the report of `inspectWrinkles`.
 *
 * @param ktx2 whether the maps are KTX 2 arrays.
 */
export function costOf({ imageBytes, strokes, gpu, influenceMapBytes }: Inspection, ktx2: boolean): Cost {
  return {
    file: imageBytes + strokes.bytes,
    gpu: (ktx2 ? gpu.bits4 : gpu.uncompressed) + influenceMapBytes,
    phone: (ktx2 ? gpu.bits8 : gpu.uncompressed) + influenceMapBytes,
  }
}

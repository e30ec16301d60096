import { HEIGHT_STEPS_PER_MM } from 'furrow/internal'

/** Value of height 0 in a 16-bit height image. */
export const HEIGHT_ZERO = 32768
/** Largest height above or below 0 that a 16-bit height image can store, millimetres. */
export const MAX_HEIGHT = (65535 - HEIGHT_ZERO) / HEIGHT_STEPS_PER_MM

/** Converts heights in millimetres to steps of a 16-bit height image. Clamps heights that the format cannot store. */
export function heightSteps(millimetres: Float32Array): Uint16Array<ArrayBuffer> {
  return Uint16Array.from(millimetres, (mm) => {
    return Math.min(Math.max(Math.round(mm * HEIGHT_STEPS_PER_MM) + HEIGHT_ZERO, 0), 65535)
  })
}

import { FurrowError } from 'furrow'
import { cannotRead } from '../base/errors.ts'

/** Remedy for a damaged image. */
export const REPAIR = 'save it again as PNG; it may be truncated'

/** Runs a decoder and converts its errors to FurrowError with the hints. */
export async function withImageErrors<T>(
  name: string,
  who: string,
  decode: () => Promise<T>,
  hints: { limit?: string; remedy?: string } = {},
): Promise<T> {
  try {
    return await decode()
  } catch (error) {
    if (error instanceof FurrowError) throw error
    throw cannotRead(who, `the image ${name}`, error, { remedy: REPAIR, ...hints })
  }
}

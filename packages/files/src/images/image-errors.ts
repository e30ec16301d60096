import { FurrowError } from 'furrow'
import { cannotRead } from '../base/errors.ts'

/** What to do about a damaged image. */
export const REPAIR = 'save it again as PNG; it may be cut off'

/** Runs the decoding of an image; what it throws becomes a FurrowError with these hints. */
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

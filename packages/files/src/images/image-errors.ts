import { FurrowError } from 'furrow'
import { cannotRead } from '../base/errors.ts'

export const REPAIR = 'save it again as PNG; it may be truncated'

/** Runs a decoder. Converts its errors to FurrowError with the given limit and remedy. */
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

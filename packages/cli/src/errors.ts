import { FurrowError } from 'furrow'

/**
 * Runs `work` and reports its errors as the command's own: users know the command, not the functions that it calls.
 *
 * @param who the command, e.g. `furrow auto`.
 * @throws FurrowError, also where the memory for maps of the size that was asked for cannot be allocated.
 */
export function withCommandErrors<T>(who: string, work: () => T): T {
  try {
    return work()
  } catch (error) {
    if (error instanceof FurrowError) throw error.reportedBy(who)
    if (!(error instanceof RangeError)) throw error
    const what = 'not enough memory for maps of this size'
    throw new FurrowError(
      { code: 'unsupported', who, what, remedy: 'choose a smaller --size' },
      { cause: error },
    )
  }
}

/**
 * The error for a file or image that cannot be read.
 *
 * @param name what could not be read, as the user knows it, e.g. `the face head.glb`.
 * @param cause what reading it threw; its first line becomes part of the message.
 */
export function cannotRead(
  who: string,
  name: string,
  cause: unknown,
  hints: { limit?: string; remedy?: string } = {},
): FurrowError {
  const what = `cannot read ${name} (${firstLine(cause)})`
  return new FurrowError({ code: 'unreadable', who, what, remedy: 'check the path', ...hints }, { cause })
}

/** The error for a file or folder that cannot be written; see `cannotRead`. */
export function cannotWrite(
  who: string,
  name: string,
  cause: unknown,
  remedy = 'choose a path that you may write to',
): FurrowError {
  const what = `cannot write ${name} (${firstLine(cause)})`
  return new FurrowError({ code: 'unwritable', who, what, remedy }, { cause })
}

/** The first line of an error's message: some libraries add stacks and hints. */
export function firstLine(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).split('\n')[0].trim()
}

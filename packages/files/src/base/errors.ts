import { FurrowError } from 'furrow'

/**
 * Runs a command's work, synchronous or not. If the work throws a FurrowError, the error gets the name of the command.
 *
 * @param who command, e.g. `furrow auto`.
 * @throws FurrowError if the work throws one, or if maps of the requested size do not fit into memory.
 */
export function withCommandErrors<T>(who: string, work: () => T): T {
  const report = (error: unknown): never => {
    throw errorOf(who, error)
  }
  try {
    const result = work()
    return result instanceof Promise ? (result.catch(report) as T) : result
  } catch (error) {
    return report(error)
  }
}

function errorOf(who: string, error: unknown): unknown {
  if (error instanceof FurrowError) return error.reportedBy(who)
  if (!(error instanceof RangeError)) return error
  const problem = 'not enough memory for maps of this size'
  return new FurrowError(
    { code: 'unsupported', who, problem, remedy: 'choose a smaller --size' },
    { cause: error },
  )
}

/** Reason and remedy per error code of the file system. */
const FILE_ERRORS: Readonly<Record<string, { reason: string; remedy: string }>> = {
  ENOENT: { reason: 'it does not exist', remedy: 'check the path' },
  ENOTDIR: { reason: 'part of the path is not a folder', remedy: 'check the path' },
  EISDIR: { reason: 'it is a folder', remedy: 'choose a file' },
  EACCES: { reason: 'permission denied', remedy: 'ask its owner, or change its permissions' },
  EPERM: { reason: 'operation not permitted', remedy: 'ask its owner, or change its permissions' },
  EROFS: { reason: 'the disk is read-only', remedy: 'choose a path on another disk' },
  ENOSPC: { reason: 'the disk is full', remedy: 'free some space, or choose another disk' },
  EDQUOT: { reason: 'disk quota exceeded', remedy: 'free some space, or choose another disk' },
  ENAMETOOLONG: { reason: 'the name is too long', remedy: 'choose a shorter name' },
  ELOOP: { reason: 'its symbolic links form a cycle', remedy: 'correct the links' },
  EMFILE: {
    reason: 'too many files are open',
    remedy: 'close other programs, or raise the limit (ulimit -n)',
  },
  EEXIST: { reason: 'the name already exists', remedy: 'choose another name' },
  ENOTEMPTY: { reason: 'the folder is not empty', remedy: 'choose another folder' },
  EBUSY: { reason: 'another program uses it', remedy: 'close that program' },
}

/**
 * Creates the error for a file or image that cannot be read.
 *
 * @param name name of the file in the message, e.g. `the face head.glb`.
 * @param cause original error. The message contains its first line.
 * @param hints.remedy used if the remedy in `FILE_ERRORS` for the cause is missing, or is only "check the path".
 */
export function cannotRead(
  who: string,
  name: string,
  cause: unknown,
  hints: { limit?: string; remedy?: string } = {},
): FurrowError {
  const known = fileError(cause)
  const problem = `cannot read ${name} (${known?.reason ?? firstLine(cause)})`
  const isMissing = known?.remedy === 'check the path'
  const remedy = (isMissing ? undefined : known?.remedy) ?? hints.remedy ?? 'check the path'
  return new FurrowError({ code: 'unreadable', who, problem, ...hints, remedy }, { cause })
}

export function cannotWrite(
  who: string,
  name: string,
  cause: unknown,
  remedy = 'choose another path',
): FurrowError {
  const known = fileError(cause)
  const problem = `cannot write ${name} (${known?.reason ?? firstLine(cause)})`
  return new FurrowError({ code: 'unwritable', who, problem, remedy: known?.remedy ?? remedy }, { cause })
}

function fileError(cause: unknown) {
  const code = (cause as NodeJS.ErrnoException | undefined)?.code
  return code !== undefined && Object.hasOwn(FILE_ERRORS, code) ? FILE_ERRORS[code] : undefined
}

/** Returns the first line of an error's message. Some libraries append stacks and hints in further lines. */
export function firstLine(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).split('\n')[0].trim()
}

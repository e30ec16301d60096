import { FurrowError } from 'furrow'

/**
 * Runs `work`, synchronous or not, and reports its errors as the command's own: users know the command, not the functions that it calls.
 *
 * @param who the command, e.g. `furrow auto`.
 * @throws FurrowError, also where the memory for maps of the size that was asked for cannot be allocated.
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

/** What the errors of the file system mean, and what helps. */
const FILE_ERRORS: Readonly<Record<string, { reason: string; remedy: string }>> = {
  ENOENT: { reason: 'it does not exist', remedy: 'check the path' },
  ENOTDIR: { reason: 'a part of its path is not a folder', remedy: 'check the path' },
  EISDIR: { reason: 'it is a folder', remedy: 'name a file' },
  EACCES: { reason: 'permission denied', remedy: 'ask its owner, or change its permissions' },
  EPERM: { reason: 'the system does not permit it', remedy: 'ask its owner, or change its permissions' },
  EROFS: { reason: 'the disk is read-only', remedy: 'choose a path on another disk' },
  ENOSPC: { reason: 'the disk is full', remedy: 'free some space, or choose another disk' },
  EDQUOT: { reason: 'your quota is used up', remedy: 'free some space, or choose another disk' },
  ENAMETOOLONG: { reason: 'its name is too long', remedy: 'choose a shorter name' },
  ELOOP: { reason: 'its links lead in a circle', remedy: 'correct the links' },
  EMFILE: {
    reason: 'too many files are open',
    remedy: 'close other programs, or raise the limit (ulimit -n)',
  },
  EEXIST: { reason: 'something else has its name', remedy: 'choose another name' },
  ENOTEMPTY: { reason: 'the folder is not empty', remedy: 'name another one; nothing is overwritten' },
  EBUSY: { reason: 'another program uses it', remedy: 'close that program' },
}

/**
 * The error for a file or image that cannot be read.
 *
 * @param name what could not be read, as the user knows it, e.g. `the face head.glb`.
 * @param cause what reading it threw; its first line becomes part of the message.
 * @param hints.remedy where nothing at the path, or what is there, is the problem.
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

/** The error for a file or folder that cannot be written; see `cannotRead`. */
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

/** The first line of an error's message: some libraries add stacks and hints. */
export function firstLine(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).split('\n')[0].trim()
}

import { FurrowError } from 'furrow'

const FOLDER_REMEDY = 'save the project as a folder or a file'

/** Problems and remedies by exception name. */
const REASONS: Readonly<Record<string, { problem: string; remedy: string }>> = {
  QuotaExceededError: {
    problem: 'the browser has no room left for this project',
    remedy: `free some disk space or delete other projects, or ${FOLDER_REMEDY}`,
  },
  SecurityError: {
    problem: 'the browser does not let this page store anything',
    remedy: `allow its data or leave the private window, or ${FOLDER_REMEDY}`,
  },
  VersionError: {
    problem: 'the projects were stored by a later version of the studio',
    remedy: 'reload the page',
  },
  // Browsers close the connection when the user clears the data of the page, or opens a later version of the page.
  InvalidStateError: {
    problem: 'the browser closed its storage',
    remedy: `wait until saving is tried again, or ${FOLDER_REMEDY}`,
  },
  NotReadableError: {
    problem: 'a file of the avatar has changed since it was opened',
    remedy: 'open it again',
  },
}

/** Converts an exception of the browser's storage to a FurrowError. */
export function storageError(cause: unknown): FurrowError {
  if (cause instanceof FurrowError) return cause
  const { name, message } = cause instanceof Error ? cause : { name: '', message: String(cause) }
  const reason = Object.hasOwn(REASONS, name) ? REASONS[name] : undefined
  const problem = reason?.problem ?? `the browser's storage failed (${message.split('\n')[0] || name})`
  const remedy = reason?.remedy ?? FOLDER_REMEDY
  return new FurrowError({ code: 'unwritable', who: 'Studio', problem, remedy }, { cause })
}

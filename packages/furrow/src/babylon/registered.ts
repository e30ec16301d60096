import { formatProblem } from '../core/error.ts'

/** Whether `registerWrinkleMaps` was called. */
let isRegistered = false
let hasWarned = false

export function markRegistered(): void {
  isRegistered = true
}

/** Logs a warning, only once, if `registerWrinkleMaps` was not called. Loaded files then have no wrinkles. */
export function warnIfUnregistered(): void {
  if (isRegistered || hasWarned) return
  hasWarned = true
  console.warn(
    formatProblem({
      who: 'wrinklesOf',
      problem: 'files have no wrinkles before registerWrinkleMaps is called',
      remedy: 'call registerWrinkleMaps before loading',
    }),
  )
}

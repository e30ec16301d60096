import { formatProblem } from '../core/error.ts'

/** Whether `registerWrinkleMaps` was called. Babylon.js does not keep a file's JSON, which would tell whether the file has wrinkles. */
let isRegistered = false
let hasWarned = false

export function markRegistered(): void {
  isRegistered = true
}

/** Warns once if `registerWrinkleMaps` was never called. */
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

import { sentence } from '../core/error.ts'

/** Whether `registerWrinkleMaps` was called. Babylon.js keeps nothing of a file that would tell whether it has wrinkles. */
let isRegistered = false
let hasWarned = false

export function noteRegistered(): void {
  isRegistered = true
}

/** Warns once where no file can have wrinkles. */
export function warnIfUnregistered(): void {
  if (isRegistered || hasWarned) return
  hasWarned = true
  console.warn(
    sentence({
      who: 'wrinklesOf',
      problem: 'no file has wrinkles before registerWrinkleMaps is called',
      remedy: 'call it before loading',
    }),
  )
}

import { Failure } from './run.mjs'

/**
 * The whole number that an option of a script gives.
 *
 * @param {string} option its name.
 * @param {string} text
 * @param {number} least
 * @returns {number}
 */
export function wholeNumber(option, text, least) {
  if (/^\d{1,15}$/.test(text) && Number(text) >= least) return Number(text)
  throw new Failure(
    `--${option} is not a whole number, got "${text}", allowed: ${least} or more; write e.g. --${option} 20`,
  )
}

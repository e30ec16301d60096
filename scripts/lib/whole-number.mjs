import { Failure } from './run.mjs'

/**
 * Parses a whole number that was given as an option of a script.
 *
 * @param {string} option name of the option, for errors.
 * @param {string} text
 * @param {number} least smallest allowed value.
 * @returns {number}
 */
export function wholeNumber(option, text, least) {
  if (/^\d{1,15}$/.test(text) && Number(text) >= least) return Number(text)
  throw new Failure(
    `--${option} is not a whole number, got "${text}", allowed: at least ${least}; write e.g. --${option} 20`,
  )
}

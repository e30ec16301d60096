import { MAX_NAME_LENGTH } from './limits.ts'

/** Excludes control characters, lone surrogates, and line and paragraph separators. These would break terminals, shaders or files. */
const NAME = new RegExp(`^[^\\p{Cc}\\p{Cs}\\p{Zl}\\p{Zp}]{1,${MAX_NAME_LENGTH}}$`, 'u')

/** Rule for names, for error messages. */
export const NAME_RULE = `1 to ${MAX_NAME_LENGTH} characters, none of them a control character or a line break`

/**
 * Whether a value is a valid name of a layer or area: 1 to 256 Unicode code points, none of them excluded by `NAME`. Names are compared
 * without Unicode normalisation.
 */
export function isName(value: unknown): value is string {
  return typeof value === 'string' && NAME.test(value)
}

import { MAX_NAME_LENGTH } from './limits.ts'

/** Excludes characters that break lines, terminals, shaders or file encodings. */
const NAME = new RegExp(`^[^\\p{Cc}\\p{Cs}\\p{Zl}\\p{Zp}]{1,${MAX_NAME_LENGTH}}$`, 'u')

/** Rule for names, as the limit in errors. */
export const NAME_RULE = `1 to ${MAX_NAME_LENGTH} characters, none of them a control character or a line break`

/**
 * Whether a value is a valid name of a layer or area: 1 to 256 Unicode code points without control characters, line or paragraph
 * separators, or lone surrogates. Names are compared without normalisation.
 */
export function isName(value: unknown): value is string {
  return typeof value === 'string' && NAME.test(value)
}

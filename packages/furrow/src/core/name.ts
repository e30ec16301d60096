import { LONGEST_NAME } from './limits.ts'

/** A class of characters that names must not have: they break lines, terminals, shaders and the encoding of files. */
const NAME = new RegExp(`^[^\\p{Cc}\\p{Cs}\\p{Zl}\\p{Zp}]{1,${LONGEST_NAME}}$`, 'u')

/** The rule, for errors. */
export const NAME_RULE = `1 to ${LONGEST_NAME} characters, none of them a control character or a line break`

/**
 * Whether a value can be the name of a layer or of an area: text of 1 to 256 characters (Unicode code points), none of them a control
 * character, a line or paragraph separator, or half of a surrogate pair. Two names are the same if their characters are.
 */
export function isName(value: unknown): value is string {
  return typeof value === 'string' && NAME.test(value)
}

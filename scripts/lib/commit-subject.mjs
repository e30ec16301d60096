const MAX_SUBJECT_LENGTH = 72

/** Beginnings of subjects that git generates. */
const BY_GIT = /^(Merge|Revert|fixup!|squash!|amend!) /

/**
 * Finds a problem in the subject of a commit.
 *
 * @param {string} message whole message. Lines that begin with `#` are ignored, as in git.
 * @returns {string | undefined} error text, or undefined.
 */
export function subjectProblem(message) {
  const [subject = '', second = ''] = message.split('\n').filter((line) => !line.startsWith('#'))
  if (BY_GIT.test(subject)) return undefined
  const length = [...subject].length
  if (length > MAX_SUBJECT_LENGTH)
    return `subject too long, got ${length} characters, allowed: ${MAX_SUBJECT_LENGTH}; move details to the body`
  if (subject.endsWith('.')) return 'subject ends with a full stop, allowed: none; remove it'
  if (second.trim() !== '') return 'body without an empty line above it; separate it from the subject'
  return undefined
}

import { Failure } from './run.mjs'

/** Returns the names that a user chose, or all if there are none. Throws `Failure` for an unknown name. */
export function chosenNames(kind, names, allowed) {
  const unknown = names.find((name) => !allowed.includes(name))
  if (unknown !== undefined)
    throw new Failure(`unknown ${kind}, got "${unknown}", allowed: ${allowed.join(', ')}; name one of these`)
  return names.length > 0 ? names : allowed
}

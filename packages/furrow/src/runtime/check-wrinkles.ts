import { wrongArgument } from '../core/argument.ts'
import type { WrinkleFaces } from './wrinkle-faces.ts'

/**
 * Checks that an argument is a `Wrinkles` object, for callers without TypeScript. Objects of another copy of the library are accepted.
 *
 * @param argument name of the argument in errors.
 * @throws FurrowError for other values, such as the list that `wrinklesOf(file)` returns.
 */
export function checkWrinkles(wrinkles: WrinkleFaces, who: string, argument = 'wrinkles'): void {
  if (typeof wrinkles?.hasArea === 'function') return
  const isList = Array.isArray(wrinkles)
  const value = isList ? `a list of ${wrinkles.length}` : wrinkles
  const limit = isList ? 'an item of the list, such as wrinklesOf(gltf)[0]' : 'an object of class Wrinkles'
  throw wrongArgument(who, argument, value, limit)
}

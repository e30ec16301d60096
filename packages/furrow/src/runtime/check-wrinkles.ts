import { wrongArgument } from '../core/argument.ts'
import type { WrinkleFaces } from './wrinkle-faces.ts'

/**
 * Checks that a caller without types passes wrinkles, in whichever copy of the library they were made.
 *
 * @throws FurrowError otherwise; a list of them, as `wrinklesOf(file)` returns, is the usual mistake.
 */
export function checkWrinkles(wrinkles: WrinkleFaces, who: string, what = 'wrinkles'): void {
  if (typeof wrinkles?.hasArea === 'function') return
  const isList = Array.isArray(wrinkles)
  const value = isList ? `a list of ${wrinkles.length}` : wrinkles
  const limit = isList ? 'one of the list, such as wrinklesOf(gltf)[0]' : 'an object of class Wrinkles'
  throw wrongArgument(who, what, value, limit)
}

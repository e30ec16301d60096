import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { WrinklesBase } from './wrinkles-base.ts'

/**
 * Checks a set that a page made; those of files were checked as they were read.
 *
 * @throws FurrowError when it is malformed.
 */
export function checkSource<T extends WrinkleSet<ArraySlice> | WrinklesBase>(source: T): T {
  if (!(source instanceof WrinklesBase)) checkWrinkleSet(source, 'Wrinkles')
  return source
}

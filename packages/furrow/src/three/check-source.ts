import { checkMapSizes } from '../core/map-sizes.ts'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { WrinklesBase } from './wrinkles-base.ts'

/**
 * Checks a set that a page made; those of files were checked as they were read.
 *
 * @throws FurrowError when it is malformed, or maps of one kind differ in size.
 */
export function checkSource<T extends WrinkleSet<ArraySlice> | WrinklesBase>(source: T): T {
  if (source instanceof WrinklesBase) return source
  checkWrinkleSet(source, 'Wrinkles')
  checkMapSizes(source.layers)
  return source
}

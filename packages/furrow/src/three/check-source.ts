import { checkMapSizes } from '../core/map-sizes.ts'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { copyLayers } from '../runtime/layer-maps.ts'
import { WrinklesBase } from './wrinkles-base.ts'

/**
 * Checks a set that a page made, and copies its layers' maps, whose texels may become those of textures; sets of files were checked as they were
 * read, and belong to nobody else.
 *
 * @throws FurrowError when it is malformed, or maps of one kind differ in size.
 */
export function checkSource<T extends WrinkleSet<ArraySlice> | WrinklesBase>(source: T): T {
  if (source instanceof WrinklesBase) return source
  checkWrinkleSet(source, 'Wrinkles')
  checkMapSizes(source.layers)
  return { ...source, layers: copyLayers(source.layers) }
}

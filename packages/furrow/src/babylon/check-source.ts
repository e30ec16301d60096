import { isSlice } from '../core/check-areas.ts'
import { FurrowError } from '../core/error.ts'
import { checkMapSizes } from '../core/map-sizes.ts'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { copyLayers } from '../runtime/layer-maps.ts'

/**
 * Checks a set that a page made, and copies its layers' maps; those of files were checked as they were read, and belong to nobody else.
 *
 * @throws FurrowError when it is malformed, maps of one kind differ in size, or its maps are in arrays of an engine.
 */
export function checkSource(source: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice> {
  checkWrinkleSet(source, 'Wrinkles')
  checkMapSizes(source.layers)
  const maps = [
    ...source.layers.flatMap((layer) => Object.values(layer)),
    ...source.areas.map(({ weights }) => weights),
  ]
  if (!maps.some((map) => typeof map === 'object' && isSlice(map)))
    return { ...source, layers: copyLayers(source.layers) }
  throw new FurrowError({
    code: 'unsupported',
    who: 'Wrinkles',
    problem: 'maps in a texture array',
    limit: 'images',
    remedy: 'pack the file without --ktx2',
  })
}

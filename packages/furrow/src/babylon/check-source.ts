import { isSlice } from '../core/check-areas.ts'
import { FurrowError } from '../core/error.ts'
import { checkMapSizes } from '../core/maps/map-sizes.ts'
import type { ArraySlice, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { copyLayers } from '../runtime/maps/layer-maps.ts'

/**
 * Checks a wrinkle set, and copies its layers, because packing replaces the texels of their maps. Sets that a loader reads need no check.
 *
 * @throws FurrowError if the set is malformed, if maps of one kind differ in size, or if maps are slices of texture arrays.
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

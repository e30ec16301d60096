import { isSlice } from '../core/check-areas.ts'
import { checkMapSizes } from '../core/map-sizes.ts'
import type { ArraySlice, Layer, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { VALUE_KINDS } from '../runtime/layer-maps.ts'
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
  return { ...source, layers: source.layers.map(copyMaps) }
}

function copyMaps(layer: Layer<ArraySlice>): Layer<ArraySlice> {
  const copies = (['normal', ...VALUE_KINDS] as const).flatMap((kind) => {
    const map = layer[kind]
    return map && !isSlice(map) ? [[kind, { ...map, data: new Uint8Array(map.data) }]] : []
  })
  return { ...layer, ...Object.fromEntries(copies) }
}

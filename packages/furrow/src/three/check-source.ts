import { checkMapSizes } from '../core/maps/map-sizes.ts'
import type { Area, ArraySlice, Layer, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { copyLayers } from '../runtime/maps/layer-maps.ts'

/** Wrinkle set read from a file. It was checked when it was read, and textures may use its pixel arrays without copying them. */
export class ReadSet implements WrinkleSet<ArraySlice> {
  readonly areas: Area<ArraySlice>[]
  readonly layers: Layer<ArraySlice>[]

  constructor({ areas, layers }: Pick<WrinkleSet<ArraySlice>, 'areas' | 'layers'>) {
    this.areas = areas
    this.layers = layers
  }
}

/**
 * Checks a wrinkle set, and copies the maps of its layers, because textures keep references to pixel arrays that the page may change. A
 * `ReadSet` is returned unchanged.
 *
 * @throws FurrowError if the set is malformed, or maps of one kind differ in size.
 */
export function checkSource(source: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice> {
  if (source instanceof ReadSet) return source
  checkWrinkleSet(source, 'Wrinkles')
  checkMapSizes(source.layers)
  return { ...source, layers: copyLayers(source.layers) }
}

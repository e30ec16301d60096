import { checkMapSizes } from '../core/map-sizes.ts'
import type { Area, ArraySlice, Layer, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { copyLayers } from '../runtime/layer-maps.ts'

/** A set that was checked as it was read, and whose texels belong to nobody else, so that textures may take them. */
export class ReadSet implements WrinkleSet<ArraySlice> {
  readonly areas: Area<ArraySlice>[]
  readonly layers: Layer<ArraySlice>[]

  constructor({ areas, layers }: Pick<WrinkleSet<ArraySlice>, 'areas' | 'layers'>) {
    this.areas = areas
    this.layers = layers
  }
}

/**
 * Checks a set that a page made, and copies its layers' maps, whose texels may become those of textures.
 *
 * @throws FurrowError when it is malformed, or maps of one kind differ in size.
 */
export function checkSource(source: WrinkleSet<ArraySlice>): WrinkleSet<ArraySlice> {
  if (source instanceof ReadSet) return source
  checkWrinkleSet(source, 'Wrinkles')
  checkMapSizes(source.layers)
  return { ...source, layers: copyLayers(source.layers) }
}

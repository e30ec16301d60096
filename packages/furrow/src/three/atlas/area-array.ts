import { boundsOf } from '../../core/bounds.ts'
import { isSlice, layerIndex } from '../../core/check-areas.ts'
import { resampleGray } from '../../core/image.ts'
import { imageArray } from '../../core/image-array.ts'
import type { Area, ArraySlice, GrayImage } from '../../core/types.ts'
import type { AreaSlot, AreaSlots } from '../../runtime/area-slots.ts'
import { type ArrayTexture, arrayOf, type Upload } from '../material/array-texture.ts'
import { areaTexture } from '../material/textures.ts'

/**
 * The areas of a wrinkle set in one texture array, and their locations in the array. An area is a group of wrinkles; its image has a weight for
 * each texel in UV space.
 */
export interface AreaArray extends AreaSlots {
  readonly texture: ArrayTexture
  /** Number of channels per slice of the texture array. Each channel may hold one area. */
  readonly channels: 1 | 4
  /** Uploads changed weights to the GPU; set by `updateArea`. */
  upload?: Upload
}

/**
 * Creates the texture array of a wrinkle set's areas. Resamples images to squares of one size, one image per slice. If the areas are already
 * in a texture array, uses that array unchanged.
 *
 * @param areas checked areas.
 * @param size edge length of the squares, texels.
 * @param who name of the caller, for errors.
 * @throws FurrowError if the areas are in several texture arrays.
 */
export function createAreaArray(
  areas: readonly Area<ArraySlice>[],
  layers: readonly { name: string }[],
  size: number,
  who: string,
): AreaArray {
  const weights = areas.map((area) => area.weights)
  const { locations, ...array } = weights.some(isSlice)
    ? sliced(weights, who)
    : packed(weights as GrayImage[], size)
  const slots = areas.map((area, i) => {
    // No spread syntax: every frame reads these objects, and V8 reads objects created by spread at half the speed.
    const { slice, channel, bounds } = locations[i]
    return { layer: layerIndex(area, layers), combine: area.combine ?? 'sum', slice, channel, bounds }
  })
  return { ...array, slots, version: 0 }
}

type LocatedAreas = Omit<AreaArray, 'slots' | 'version'> & {
  locations: Pick<AreaSlot, 'slice' | 'channel' | 'bounds'>[]
}

function packed(weights: readonly GrayImage[], size: number): LocatedAreas {
  const array = imageArray(
    weights.map((image) => resampleGray(image, size)),
    1,
  )
  const locations = weights.map((_, slice) => ({ slice, channel: 0, bounds: boundsOf(array, slice) }))
  return { texture: areaTexture(array), width: size, height: size, channels: 1, locations }
}

function sliced(weights: readonly (GrayImage | ArraySlice)[], who: string): LocatedAreas {
  const texture = arrayOf(weights, who, 'areas')
  const { width, height } = texture.image
  // The compressed texels are not decoded, so the texels that an area covers are unknown.
  const bounds = { x0: 0, y0: 0, x1: width, y1: height }
  const locations = weights.filter(isSlice).map(({ slice, channel }) => ({ slice, channel, bounds }))
  return { texture, width, height, channels: 4, locations }
}

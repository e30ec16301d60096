import { boundsOf } from '../../core/bounds.ts'
import { isSlice, layerIndex } from '../../core/check-areas.ts'
import { resampleGray } from '../../core/image.ts'
import { imageArray } from '../../core/image-array.ts'
import type { Area, ArraySlice, GrayImage } from '../../core/types.ts'
import type { AreaSlot, AreaSlots } from '../../runtime/area-slots.ts'
import { type ArrayTexture, arrayOf, type Upload } from '../material/array-texture.ts'
import { areaTexture } from '../material/textures.ts'

/** The areas of a set as one array on the GPU. */
export interface AreaArray extends AreaSlots {
  readonly texture: ArrayTexture
  /** Channels per slice, each of which may hold an area. */
  readonly channels: 1 | 4
  /** Uploads weights that changed; set by `updateArea`. */
  upload?: Upload
}

/**
 * Creates the array of a set's areas. Images are resampled to a square grid and packed one per slice; slices of one array are used
 * unchanged.
 *
 * @param areas that were checked.
 * @param size side of the grid in texels.
 * @param who names the caller in errors.
 * @throws FurrowError when the areas are in several arrays.
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
    // By name: what a spread makes takes twice as long to read, in every frame.
    const { slice, channel, bounds } = locations[i]
    return { layer: layerIndex(area, layers), combine: area.combine ?? 'sum', slice, channel, bounds }
  })
  return { ...array, slots, version: 0 }
}

/** An array, and where each area is in it. */
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
  // Compressed blocks are not decoded, so weights above 0 may be anywhere.
  const bounds = { x0: 0, y0: 0, x1: width, y1: height }
  const locations = weights.filter(isSlice).map(({ slice, channel }) => ({ slice, channel, bounds }))
  return { texture, width, height, channels: 4, locations }
}

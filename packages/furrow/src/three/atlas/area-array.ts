import { boundsOf } from '../../core/bounds.ts'
import { packAreas } from '../../core/pack.ts'
import type { Area, ArraySlice, GrayImage } from '../../core/types.ts'
import { isSlice, layerIndex } from '../../core/wrinkle-set.ts'
import type { AreaSlot, AreaSlots } from '../../runtime/area-slots.ts'
import { type ArrayTexture, arrayOf } from '../material/array-texture.ts'
import { areaTexture } from '../material/textures.ts'

/** The areas of a set as one array on the GPU. */
export interface AreaArray extends AreaSlots {
  readonly texture: ArrayTexture
  /** Channels of a slice that hold areas: 1, or up to 4. */
  readonly channels: 1 | 4
}

/**
 * Puts areas on the GPU: images are packed one per slice, resampled to a common square grid; slices of one array
 * are used as they are.
 *
 * @param size side of the grid in texels.
 * @throws FurrowError where an image is malformed, or the areas lie in several arrays.
 */
export function createAreaArray(
  areas: readonly Area<ArraySlice>[],
  layers: readonly { name: string }[],
  size: number,
  who: string,
): AreaArray {
  const own = areas.map(({ weights }) => weights)
  const { locations, ...array } = own.some(isSlice) ? sliced(own, who) : packed(own as GrayImage[], size, who)
  const slots = areas.map((area, i) => ({
    layer: layerIndex(area, layers),
    combine: area.combine ?? ('sum' as const),
    ...locations[i],
  }))
  return { ...array, slots }
}

type UnassignedArray = Omit<AreaArray, 'slots'> & {
  locations: Pick<AreaSlot, 'slice' | 'channel' | 'bounds'>[]
}

function packed(weights: readonly GrayImage[], size: number, who: string): UnassignedArray {
  const array = packAreas(weights, size, who)
  const locations = weights.map((_, slice) => ({ slice, channel: 0, bounds: boundsOf(array, slice) }))
  return { texture: areaTexture(array), width: size, height: size, channels: 1, locations }
}

function sliced(weights: readonly (GrayImage | ArraySlice)[], who: string): UnassignedArray {
  const texture = arrayOf(weights, who, 'areas')
  const { width, height } = texture.image
  // Compressed blocks are not decoded: weights above 0 may be anywhere.
  const bounds = { x0: 0, y0: 0, x1: width, y1: height }
  const locations = weights.filter(isSlice).map(({ slice, channel }) => ({ slice, channel, bounds }))
  return { texture, width, height, channels: 4, locations }
}

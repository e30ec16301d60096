import { type Bounds, boundsOf } from '../../core/bounds.ts'
import { packAreas } from '../../core/pack.ts'
import type { Area, ArraySlice, Combine, GrayImage } from '../../core/types.ts'
import { isSlice, layerIndex } from '../../core/wrinkle-set.ts'
import { type ArrayTexture, arrayOf } from '../loader/texture-arrays.ts'
import { areaTexture } from '../material/textures.ts'

/** An area as the GPU sees it; its activation stands at the same index as it in the list. */
export interface Slot {
  /** Index of its layer. */
  layer: number
  combine: Combine
  /** Where its weights lie in the array: which slice, which channel of it, and which texels are above 0. */
  slice: number
  channel: number
  bounds: Bounds
}

/** The areas of a set as one array on the GPU. */
export interface AreaArray {
  texture: ArrayTexture
  width: number
  height: number
  /** Channels of a slice that hold areas: 1, or up to 4. */
  channels: 1 | 4
  slots: Slot[]
}

/**
 * Puts areas on the GPU: images are packed one to a slice, resampled to a common square grid; slices of one array
 * stay as they are.
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
  const maps = own.some(isSlice) ? sliced(own, who) : packed(own as GrayImage[], size, who)
  const slots = areas.map((area, i) => ({
    layer: layerIndex(area, layers),
    combine: area.combine ?? ('sum' as const),
    ...maps.places[i],
  }))
  return { ...maps, slots }
}

type Maps = Omit<AreaArray, 'slots'> & { places: Pick<Slot, 'slice' | 'channel' | 'bounds'>[] }

function packed(weights: readonly GrayImage[], size: number, who: string): Maps {
  const array = packAreas(weights, size, who)
  const places = weights.map((_, slice) => ({ slice, channel: 0, bounds: boundsOf(array, slice) }))
  return { texture: areaTexture(array), width: size, height: size, channels: 1, places }
}

function sliced(weights: readonly (GrayImage | ArraySlice)[], who: string): Maps {
  const texture = arrayOf(weights, who, 'areas')
  const { width, height } = texture.image
  // Nobody looks into compressed blocks: weights above 0 may be anywhere.
  const bounds = { x0: 0, y0: 0, x1: width, y1: height }
  const places = weights.filter(isSlice).map(({ slice, channel }) => ({ slice, channel, bounds }))
  return { texture, width, height, channels: 4, places }
}

import { boundsOf } from '../../core/bounds.ts'
import { layerIndex } from '../../core/check-areas.ts'
import { resampleGray } from '../../core/image.ts'
import { type ImageArray, imageArray } from '../../core/image-array.ts'
import type { Area } from '../../core/types.ts'
import type { AreaSlots } from '../../runtime/area-slots.ts'

/** Weights of all areas of influence of a wrinkle set. They are resampled to one size and packed into one array with a slice per area. */
export interface AreaSlices extends AreaSlots {
  readonly images: ImageArray
}

/**
 * Resamples areas to squares of one size and packs them.
 *
 * @param areas areas that `checkAreas` has accepted.
 * @param size width and height of the squares, in texels.
 */
export function packSlices(
  areas: readonly Area[],
  layers: readonly { name: string }[],
  size: number,
): AreaSlices {
  const images = imageArray(
    areas.map(({ weights }) => resampleGray(weights, size)),
    1,
  )
  const slots = areas.map((area, slice) => ({
    layer: layerIndex(area, layers),
    combine: area.combine ?? ('sum' as const),
    slice,
    channel: 0,
    bounds: boundsOf(images, slice),
  }))
  return { images, slots, width: size, height: size, version: 0 }
}

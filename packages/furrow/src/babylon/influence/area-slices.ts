import { boundsOf } from '../../core/bounds.ts'
import { layerIndex } from '../../core/check-areas.ts'
import { resampleGray } from '../../core/image.ts'
import { type ImageArray, imageArray } from '../../core/image-array.ts'
import type { Area } from '../../core/types.ts'
import type { AreaSlots } from '../../runtime/area-slots.ts'

/** Areas of a set as images of one size, one per slice. */
export interface AreaSlices extends AreaSlots {
  readonly images: ImageArray
}

/**
 * Resamples a set's areas to a square grid.
 *
 * @param areas checked areas.
 * @param size side of the grid, texels.
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

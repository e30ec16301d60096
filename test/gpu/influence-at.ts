import type { Area, GrayImage } from 'furrow'
import { packAreas, reference } from 'furrow/internal'

/**
 * The reference's influence at a point, as a function of u, v and the index of a layer.
 *
 * @param activations of the areas.
 * @param layers names of the layers; not needed where there is one.
 * @param size width and height of influence maps in texels.
 */
export function influenceAt(
  areas: readonly Area[],
  activations: readonly number[],
  size: number,
  layers: readonly string[] = [],
): (u: number, v: number, layer?: number) => number {
  const packed = packAreas(
    areas.map(({ weights }) => weights as GrayImage),
    size,
  )
  const table = areas.map(({ layer, combine = 'sum' }, i) => ({
    activation: activations[i],
    layer: Math.max(0, layers.indexOf(layer!)),
    combine,
  }))
  return (u, v, layer = 0) => reference.influenceFromMap(packed, table, u, v, layer)
}

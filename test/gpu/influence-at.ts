import type { Area, GrayImage } from 'furrow'
import { packAreas, reference } from 'furrow/internal'

/**
 * Returns a function of u, v and layer index that computes the influence in float64.
 *
 * @param activations activations of the areas.
 * @param layers names of the layers; optional for one layer.
 * @param size width of influence maps, texels.
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

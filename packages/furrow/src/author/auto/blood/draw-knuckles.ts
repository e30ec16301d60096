import { BLOOD_AT_REST } from '../../../core/blood.ts'
import type { GrayImage } from '../../../core/types.ts'
import { length3 } from '../../../math/vector.ts'
import type { SkinTexels } from '../../skin/skin-texels.ts'
import { bloodByte } from '../../valley-blood.ts'
import type { Knuckles } from '../limbs/knuckles.ts'
import type { BloodArea, BloodSource } from './draw-blood.ts'
import { PRESSING } from './flushes.ts'

/** Layer on which the paleness is drawn. Knuckles have no lines, so it does not matter which. */
const LAYER = 0

/**
 * Draws the pale knuckles of fists into a blood map.
 *
 * @param maps blood maps of the layers, changed in place.
 * @returns an area for each hand.
 */
export function drawKnuckles(
  { texels, areaTexels }: Pick<BloodSource, 'texels' | 'areaTexels'>,
  hands: readonly Knuckles[],
  maps: readonly GrayImage[],
): BloodArea[] {
  return hands.map((hand) => {
    const { name, driver } = hand
    const { width, height } = areaTexels
    const weights = { width, height, data: new Uint8Array(width * height) }
    visitSpots(areaTexels, hand, (texel, share) => {
      weights.data[texel] = Math.round(255 * Math.sqrt(share))
    })
    const { data } = maps[LAYER]
    visitSpots(texels, hand, (texel, share) => {
      const own = (data[texel] - BLOOD_AT_REST) / (255 - BLOOD_AT_REST)
      data[texel] = bloodByte(own - Math.sqrt(share))
    })
    return { name, layer: LAYER, weights, drivers: [driver, { type: 'time', area: name, ...PRESSING }] }
  })
}

/** Visits the texels near knuckles. `share` is 1 in the middle of a knuckle, and falls to 0 at its edge. */
function visitSpots(
  texels: SkinTexels,
  { places, radius }: Knuckles,
  visit: (texel: number, share: number) => void,
): void {
  const isNear = (low: Float64Array, high: Float64Array) =>
    places.some((place) => place.every((value, k) => low[k] < value + radius && high[k] > value - radius))
  texels.visitNear(isNear, (texel, position) => {
    let nearest = radius
    for (const [x, y, z] of places)
      nearest = Math.min(nearest, length3(position[0] - x, position[1] - y, position[2] - z))
    const fade = 1 - (nearest / radius) ** 2
    if (fade > 0) visit(texel, fade * fade)
  })
}

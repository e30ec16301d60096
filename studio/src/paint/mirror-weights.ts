import type { GrayImage } from 'furrow'
import { interpolateTexels } from 'furrow/internal'
import { checkPaintable } from './paint-map.ts'
import { clampedBarycentrics, type PaintSkin } from './paint-skin.ts'

/** Margin around the bounds of the mirror image, millimetres, because faces are not exactly symmetric. */
const TOLERANCE = 6

/**
 * Mirrors the weights of an area across the middle plane of the face. Each texel takes the weight at the point of the skin that is nearest to
 * the texel's mirror image. In the code, a place is a pair of a texel and a triangle that contains it; see `PaintMapArrays`.
 *
 * @throws FurrowError if the image cannot be painted.
 */
export function mirrorWeights(image: GrayImage, skin: PaintSkin): GrayImage {
  checkPaintable(image)
  const { width: size, height, data } = image
  const { starts, texels, positions, locator } = skin.mapOf(size)
  const [low, high] = otherSide(image, texels, positions)
  const out = new Uint8Array(data.length)
  const weightAt = (column: number, row: number) => data[row * size + column]
  const weights = new Float64Array(3)
  for (let place = 0; place < starts[starts.length - 1]; place++) {
    const [x, y, z] = positions.subarray(3 * place, 3 * place + 3)
    if (x < low[0] || y < low[1] || z < low[2] || x > high[0] || y > high[1] || z > high[2]) continue
    const { triangle, position } = skin.mirrored([x, y, z])
    clampedBarycentrics(skin.surface, triangle, position, weights)
    const [u, v] = locator.uvAt(triangle, weights)
    const weight = Math.round(interpolateTexels(image, u * size - 0.5, v * size - 0.5, weightAt))
    // If several parts of the skin share a texel, take their maximum weight.
    if (weight > out[texels[place]]) out[texels[place]] = weight
  }
  return { width: size, height, data: out }
}

/** Returns the bounds of the area's mirror image on the skin, millimetres. */
function otherSide({ data }: GrayImage, texels: Uint32Array, positions: Float32Array) {
  const [low, high] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ]
  for (let place = 0; place < texels.length; place++) {
    if (data[texels[place]] === 0) continue
    for (let k = 0; k < 3; k++) {
      const value = k === 0 ? -positions[3 * place] : positions[3 * place + k]
      low[k] = Math.min(low[k], value - TOLERANCE)
      high[k] = Math.max(high[k], value + TOLERANCE)
    }
  }
  return [low, high]
}

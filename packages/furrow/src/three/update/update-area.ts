import type { DataArrayTexture } from 'three'
import { isObject, wrongArgument } from '../../core/argument.ts'
import { boundsOf, widen } from '../../core/bounds.ts'
import { isSlice } from '../../core/check-areas.ts'
import { checkImage, resampleGray } from '../../core/image.ts'
import type { ImageArray } from '../../core/image-array.ts'
import type { GrayImage } from '../../core/types.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { compressed } from './compressed.ts'
import { changesOf } from './texture-changes.ts'

/**
 * Gives an area new weights, which the next frame shows: on these wrinkles, and on all that use the same textures. Its activation,
 * drivers, layer and place in the order stay. Only the rectangle that the area covers is uploaded, so that it may be called for every
 * movement of a brush. Tension is measured under the weights that the area had when its drivers were set: call
 * `setDrivers(wrinkles, wrinkles.drivers)` after a stroke.
 *
 * @param wrinkles of the face.
 * @param name of the area.
 * @param weights 255 = fully visible. Any size, resampled as in `new Wrinkles`, which takes longer than the size that they already have,
 *   `areaSize`.
 * @throws FurrowError when no area has that name, the image is malformed, the areas are in KTX 2 textures, or the wrinkles were disposed
 *   of; nothing then changes.
 */
export function updateArea(wrinkles: WrinklesBase, name: string, weights: GrayImage): void {
  checkWrinkles(wrinkles, WHO)
  const mesh = meshOf(wrinkles)
  mesh.checkInUse(WHO)
  mesh.getActivation(name)
  const { areas, shaderInputs } = mesh
  if (!isObject(weights)) throw wrongArgument(WHO, `weights of area "${name}"`, weights, 'a gray image')
  checkImage(weights, 'gray', `${WHO} area "${name}"`)
  const index = areas.findIndex((area) => area.name === name)
  if (isSlice(areas[index].weights)) throw compressed(`${WHO} area "${name}"`)

  const { texture, slots, width } = shaderInputs.areas
  const array = texture.image as ImageArray
  const slot = slots[index]
  array.data.set(resampleGray(weights, width).data, slot.slice * array.width * array.height)
  const changed = { ...slot.bounds }
  slot.bounds = boundsOf(array, slot.slice)
  widen(changed, slot.bounds)
  areas[index].weights = weights
  shaderInputs.areas.version++
  const changes = changesOf(texture as DataArrayTexture)
  changes.add(slot.slice, changed)
  shaderInputs.areas.upload ??= (renderer) => changes.upload(renderer)
}

const WHO = 'updateArea'

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
 * Replaces the weights of an area of influence from the next frame on. The change affects all `Wrinkles` that share the textures. Uploads only
 * the rectangle that the area covers, so it can be called for every movement of a brush. Tension drivers keep the old weights until the
 * drivers are set again. Call `setDrivers(wrinkles, wrinkles.drivers)` after a brush stroke.
 *
 * @param wrinkles wrinkles of the face.
 * @param name name of the area.
 * @param weights gray image of any size, 255 = fully visible. Resampled if its size is not `areaSize`, see `WrinklesOptions`.
 * @throws FurrowError if the area is unknown, if the image is malformed, if areas are KTX 2 textures, or if the wrinkles are disposed of. The
 *   area then stays unchanged.
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

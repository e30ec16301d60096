import { checkFinite, isObject, wrongArgument } from '../../core/argument.ts'
import type { Layer } from '../../core/types.ts'
import { checkBloodAmplitude } from '../../core/wrinkle-set.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'
import { unknownLayer } from './unknown-layer.ts'

const WHO = 'scaleLayer'

/** How strongly a layer shows; see `Layer`. */
export type LayerScale = Pick<Layer, 'normalScale' | 'occlusionStrength' | 'bloodAmplitude'>

/**
 * Sets how strongly a layer shows, from the next frame on: on these wrinkles, and on all that use the same textures. Nothing is compiled
 * or uploaded, except in the modes `paper` and `composed`, which draw their maps again.
 *
 * @param wrinkles of the face.
 * @param name of the layer.
 * @param scale what is left out stays.
 * @throws FurrowError when no layer has that name, a number is not finite or out of its range, or the wrinkles were disposed of; nothing then changes.
 */
export function scaleLayer(wrinkles: WrinklesBase, name: string, scale: LayerScale): void {
  checkWrinkles(wrinkles, WHO)
  const mesh = meshOf(wrinkles)
  mesh.checkInUse(WHO)
  const { textures } = mesh.shaderInputs
  const index = textures.layers.findIndex((layer) => layer.name === name)
  if (index < 0) throw unknownLayer(name, textures.layers, WHO)
  if (!isObject(scale))
    throw wrongArgument(WHO, 'scale', scale, 'normalScale, occlusionStrength, bloodAmplitude')
  const layer = textures.layers[index]
  const {
    normalScale = layer.normalScale ?? 1,
    occlusionStrength = layer.occlusionStrength ?? 1,
    bloodAmplitude = layer.bloodAmplitude ?? 0,
  } = scale
  checkFinite(normalScale, `normalScale of layer "${name}"`, WHO)
  checkFinite(occlusionStrength, `occlusionStrength of layer "${name}"`, WHO)
  checkBloodAmplitude(bloodAmplitude, name, WHO)
  textures.layers[index] = { ...layer, normalScale, occlusionStrength, bloodAmplitude }
  textures.normalScale.value.setComponent(index, normalScale)
  textures.occlusionStrength.value.setComponent(index, occlusionStrength)
  textures.bloodAmplitude.value.setComponent(index, bloodAmplitude)
  textures.version++
}
